#pragma once
// The library's side of every race, written once against the wire_format concept.
#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "trama/core/view.hpp"
#include "words.hpp"

namespace trama::bench {

/// What a format adds to the concept; see bench/formats/.
template <class F>
struct traits;

template <class F>
using units = std::vector<typename F::unit>;
template <class F>
using unit_span = std::span<const typename F::unit>;

/// Calls `f(word)` for the envelope, the key and the fields of a message.
template <class F, class M>
void each_message_word(const typename F::envelope& e, const M& m, auto&& f) {
    traits<F>::each_envelope_word(e, f);
    f(static_cast<std::uint64_t>(M::key));
    each_word<true>(m, f);
}
/// Calls `f(word)` for the two fields that are read by view, if this is the message that has them.
template <class F, class M>
void each_chosen_word(const M& m, auto&& f) {
    if constexpr (std::is_same_v<M, typename traits<F>::chosen>) {
        f(as_word(m.*traits<F>::first));
        f(as_word(m.*traits<F>::second));
    }
}

/// Feeds `in` in pieces of `chunk` units (0: whole) and calls `f(event)` for everything that comes out, by `read` or `read_ahead`.
template <class F, bool Ahead = false>
[[gnu::always_inline]] inline void drive(unit_span<F> in, std::size_t chunk, auto&& f) {
    typename F::decoder decoder;
    const std::size_t piece = chunk == 0 ? std::max<std::size_t>(in.size(), 1) : chunk;
    for (bool ended = false;;) {
        const auto part = in.first(std::min(piece, in.size()));
        in = in.subspan(part.size());
        if constexpr (Ahead) read_ahead<F>(decoder, part, f);
        else read<F>(decoder, part, f);
        if (ended) return;
        if (!in.empty()) continue;
        decoder.finish();
        ended = true;
    }
}

/// Finds the packets.
template <class F, bool Ordered>
tally framing(unit_span<F> in, std::size_t chunk) {
    account<Ordered> a;
    drive<F>(in, chunk, [&](const auto& event) __attribute__((always_inline)) {
        if (event || event.code == errc::unknown_message) a.packet(event.length);
        else a.error(event.length, static_cast<std::uint64_t>(event.code));
    });
    return a.result();
}

/// Finds the packets and hands each typed message to a visitor that reads all of its fields, in order.
template <class F, bool Ordered, bool Validate, bool Ahead = false>
tally typed(unit_span<F> in, std::size_t chunk) {
    account<Ordered> a;
    drive<F, Ahead>(in, chunk, [&](const auto& event) __attribute__((always_inline)) {
        if (!event) return a.error(event.length, static_cast<std::uint64_t>(event.code));
        const error e = visit<F>(event.packet, [&]<class M>(const M& m) __attribute__((always_inline)) {
            bool good = true;
            if constexpr (Validate) a.count(good = is_valid(m));
            if constexpr (Ordered) {
                each_message_word<F>(event.packet.envelope(), m, [&](std::uint64_t word) { a.sum.add(word); });
                a.mark(good);
            } else {
                std::uint64_t head = 0;
                traits<F>::each_envelope_word(event.packet.envelope(), [&](std::uint64_t word) __attribute__((always_inline)) { head += word; });
                a.sum.value += word_of(m) + static_cast<std::uint64_t>(M::key) + head;
            }
        });
        ++a.messages;
        a.errors += e ? 1 : 0;
    });
    return a.result();
}

/// Finds the packets and reads two fields of one kind of message by view.
template <class F, bool Ordered>
tally selected(unit_span<F> in, std::size_t chunk) {
    account<Ordered> a;
    drive<F>(in, chunk, [&](const auto& event) __attribute__((always_inline)) {
        if (!event) return a.error(event.length, static_cast<std::uint64_t>(event.code));
        ++a.messages;
        const auto v = view_as<typename traits<F>::chosen>(event.packet);
        if (!v) return;
        a.words([&](auto&& f) __attribute__((always_inline)) {
            f(as_word(v->template get<traits<F>::first>().value_or({})));
            f(as_word(v->template get<traits<F>::second>().value_or({})));
        });
    });
    return a.result();
}

template <class F, task T, bool Ordered>
tally by_library(unit_span<F> in, std::size_t chunk) {
    if constexpr (T == task::framing) return framing<F, Ordered>(in, chunk);
    else if constexpr (T == task::selected) return selected<F, Ordered>(in, chunk);
    else return typed<F, Ordered, T == task::validated>(in, chunk);
}

template <class F>
using library_task = tally (*)(unit_span<F>, std::size_t chunk);
/// The library at all tasks. Each format compiles the timed ones apart, with nothing else in the source.
template <class F, bool Ordered>
constexpr std::array<library_task<F>, std::size(all_tasks)> library_tasks() {
    return {by_library<F, task::framing, Ordered>, by_library<F, task::typed, Ordered>, by_library<F, task::validated, Ordered>, by_library<F, task::selected, Ordered>};
}

/// What the generator of a stream knows about it.
struct known {
    std::uint64_t messages = 0;
    ordered_sum lengths{}, fields{}, chosen{};

    /// What a contender must come to that does `t` in order; all messages of these streams are valid.
    tally answer(task t) const { return {messages, t == task::framing ? lengths.value : t == task::selected ? chosen.value : fields.value, 0}; }
    void add(const known& more) {
        messages += more.messages;
        lengths.add(more.lengths);
        fields.add(more.fields);
        chosen.add(more.chosen);
    }
};

/// A stream and what it was made of.
template <class F>
struct stream {
    units<F> data;
    known made_of{};
};
template <class F>
using shared_stream = std::shared_ptr<const stream<F>>;

template <class F>
std::span<const std::uint8_t> bytes_of(const units<F>& data) { return {reinterpret_cast<const std::uint8_t*>(data.data()), data.size() * sizeof(typename F::unit)}; }

/// Hand-written code for all tasks, to be timed and, with an ordered sum, to be compared.
template <class F>
struct by_hand_code {
    const char* name;
    struct { tally (*run)(unit_span<F>), (*proof)(unit_span<F>); } tasks[std::size(all_tasks)];
};
/// `Code::run<T, Ordered>` for all tasks.
template <class F, class Code>
constexpr by_hand_code<F> code_of(const char* name) {
    const auto both = []<task T>() { return typename std::remove_extent_t<decltype(by_hand_code<F>::tasks)>{Code::template run<T, false>, Code::template run<T, true>}; };
    return {name, {both.template operator()<task::framing>(), both.template operator()<task::typed>(), both.template operator()<task::validated>(),
                   both.template operator()<task::selected>()}};
}

}  // namespace trama::bench
