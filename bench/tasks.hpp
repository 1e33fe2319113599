#pragma once
// The library's side of every race, written once against the wire_format concept.
#include <algorithm>
#include <memory>
#include <vector>

#include "harness.hpp"
#include "trama/core/view.hpp"

namespace trama::bench {

/// What a format adds to the concept; see bench/formats/.
template <class F>
struct traits;

template <class F>
using units = std::vector<typename F::unit>;
template <class F>
using unit_span = std::span<const typename F::unit>;

/// One word that depends on all of a field's value. The hand-written code sums the same words.
template <class V>
[[gnu::always_inline]] inline std::uint64_t word_of(const V& v) {
    if constexpr (std::is_enum_v<V> || std::integral<V>) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(v));
    } else if constexpr (requires { v.columns; }) {
        const auto* p = reinterpret_cast<const std::uint8_t*>(v.columns.data());
        return load_le<std::uint64_t>(p) + load_le<std::uint16_t>(p + v.columns.size() - 2);
    } else if constexpr (requires { v.bytes(); }) {
        return v.empty() ? 0 : v.size() + v[0] + v[v.size() - 1];
    } else if constexpr (has_layout<V>) {
        return [&]<std::size_t... I>(std::index_sequence<I...>) {
            return (std::uint64_t{0} + ... + word_of(v.*field_of<V, I>.member));
        }(std::make_index_sequence<V::layout.count>{});
    } else {
        std::uint64_t sum = 0;
        for (const auto& one : v) sum += word_of(one);
        return sum;
    }
}

/// Feeds `in` in pieces of `chunk` units (0: whole) and calls `f(event)` for everything that comes out.
template <class F>
[[gnu::always_inline]] inline void drive(unit_span<F> in, std::size_t chunk, auto&& f) {
    typename F::decoder decoder;
    const std::size_t piece = chunk == 0 ? std::max<std::size_t>(in.size(), 1) : chunk;
    while (!in.empty()) {
        auto part = in.first(std::min(piece, in.size()));
        in = in.subspan(part.size());
        read<F>(decoder, part, f);
    }
    decoder.finish();
    read<F>(decoder, {}, f);
}

// Each task counts in variables of its own: a tally is returned through memory, which the loop would then write to.

/// Finds the packets.
template <class F>
tally framing(unit_span<F> in, std::size_t chunk) {
    std::uint64_t messages = 0, sum = 0, errors = 0;
    drive<F>(in, chunk, [&](const auto& event) __attribute__((always_inline)) {
        if (event || event.code == errc::unknown_message) {
            ++messages;
            sum += event.length;
        } else {
            ++errors;
        }
    });
    return {messages, sum, errors};
}

/// Finds the packets and hands each typed message to a visitor that reads all of its fields, in order.
template <class F, bool Validate = false>
tally typed(unit_span<F> in, std::size_t chunk) {
    std::uint64_t messages = 0, sum = 0, errors = 0;
    drive<F>(in, chunk, [&](const auto& event) __attribute__((always_inline)) {
        if (!event) {
            ++errors;
            return;
        }
        const error e = visit<F>(event.packet, [&]<class M>(const M& m) __attribute__((always_inline)) {
            if constexpr (Validate) errors += is_valid(m) ? 0 : 1;
            sum += word_of(m) + static_cast<std::uint64_t>(M::key) + traits<F>::word_of_envelope(event.packet);
        });
        ++messages;
        errors += e ? 1 : 0;
    });
    return {messages, sum, errors};
}

/// Finds the packets and reads two fields of one kind of message by view.
template <class F>
tally selected(unit_span<F> in, std::size_t chunk) {
    std::uint64_t messages = 0, sum = 0, errors = 0;
    drive<F>(in, chunk, [&](const auto& event) __attribute__((always_inline)) {
        if (!event) {
            ++errors;
            return;
        }
        ++messages;
        sum += traits<F>::two_fields(event.packet);
    });
    return {messages, sum, errors};
}

/// A stream and how many messages it is made of.
template <class F>
struct stream {
    units<F> data;
    std::uint64_t messages = 0;
};
template <class F>
using shared_stream = std::shared_ptr<const stream<F>>;

/// "whole" or the number of bytes.
inline std::string chunk_name(std::size_t bytes) {
    return bytes == 0 ? "whole" : bytes % 1024 == 0 ? std::to_string(bytes / 1024) + " Ki" : std::to_string(bytes);
}

/// The library doing `task`, for each of the chunk sizes, given in bytes.
template <class F>
void add_library(race& r, const shared_stream<F>& s, tally (*task)(unit_span<F>, std::size_t), std::initializer_list<std::size_t> chunks) {
    for (const std::size_t bytes : chunks) {
        const std::size_t size = sizeof(typename F::unit);
        const std::size_t chunk = bytes == 0 ? 0 : std::max<std::size_t>(1, bytes / size);
        r.contenders.push_back({"trama", chunk_name(bytes), role::library, s->data.size() * size, 1,
                                [s, task, chunk] { return task(s->data, chunk); }, {}});
    }
}
/// Hand-written code or a limit, on the whole stream.
template <class F>
void add_whole(race& r, const shared_stream<F>& s, const char* name, role part, int group, tally (*task)(unit_span<F>)) {
    r.contenders.push_back({name, "whole", part, s->data.size() * sizeof(typename F::unit), group, [s, task] { return task(s->data); }, {}});
}

}  // namespace trama::bench
