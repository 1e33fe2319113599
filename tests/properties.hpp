#pragma once
/// Properties that hold for every wire format. Written once, instantiated per format, constexpr throughout.
/// Nothing here knows a byte of any format: the vectors and messages come from the caller.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "trama/core/view.hpp"
#include "trama/core/wire_format.hpp"

namespace trama::properties {

template <wire_format F>
using units = std::span<const typename F::unit>;

/// Room for any packet of the format, filled with a unit that no encoder writes by chance.
template <wire_format F>
struct page {
    std::array<typename F::unit, F::max_units + 2> all{};

    constexpr page() { all.fill(mark()); }
    static constexpr typename F::unit mark() {
        if constexpr (std::is_integral_v<typename F::unit>) return typename F::unit{0xA5};
        else return typename F::unit{.id = 0x7A5, .length = 5, .data = {0xA5}};
    }
    constexpr bool untouched_from(std::size_t first) const {
        return std::all_of(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [](const auto& u) { return u == mark(); });
    }
};

/// encode gives exactly the golden units and nothing behind them, and refuses every shorter span without touching it.
template <wire_format F, class M>
constexpr bool encodes_to(const typename F::envelope& e, const M& m, units<F> golden, std::size_t stride = 1) {
    if (F::encoded_size(m) != golden.size()) return false;
    for (std::size_t room = 0; room < golden.size(); room += stride) {
        page<F> out;
        const auto size = F::encode(e, m, std::span(out.all).first(room));
        if (size || size.code() != errc::buffer_too_small || !out.untouched_from(0)) return false;
    }
    for (const std::size_t room : {golden.size(), golden.size() + 2}) {
        page<F> checked, raw;
        const auto size = F::encode(e, m, std::span(checked.all).first(room));
        if (!size || *size != golden.size() || !checked.untouched_from(golden.size())) return false;
        const auto unchecked = F::encode_unchecked(e, m, std::span(raw.all).first(room));
        if (!unchecked || *unchecked != golden.size() || raw.all != checked.all) return false;
        if (!std::equal(golden.begin(), golden.end(), checked.all.begin())) return false;
    }
    return true;
}

/// Every field read by itself is the message's.
template <class M, class Packet>
constexpr bool views_agree(const Packet& p, const M& m) {
    if constexpr (M::layout.fixed) {
        const auto v = view_as<M>(p);
        bool same = v.has_value();
        each_index<M>([&]<std::size_t I>() {
            constexpr auto member = std::remove_cvref_t<decltype(field_of<M, I>)>::member;
            if (!same) return;
            const auto one = v->template get<member>();
            same = one && *one == m.*member;
        });
        return same;
    } else {
        return true;
    }
}

/// What a packet should carry. Virtual, so that what feeds decoders and visits is compiled once per format, not per message.
template <wire_format F>
struct expectation {
    typename F::envelope envelope;

    /// Whether all ways that name the type lead from the packet to the message.
    constexpr virtual bool decodes(const typename F::packet& p) const = 0;

protected:
    constexpr explicit expectation(const typename F::envelope& e) : envelope(e) {}
    ~expectation() = default;
};
template <wire_format F, class M>
struct expected_message final : expectation<F> {
    const M& message;

    constexpr expected_message(const typename F::envelope& e, const M& m) : expectation<F>(e), message(m) {}
    constexpr bool decodes(const typename F::packet& p) const override {
        const auto back = decode<M>(p);
        M into{};
        return back && *back == message && !decode_into(p, into) && into == message && views_agree(p, message);
    }
};

/// All ways to the typed message lead to the one expected, whose units are `stream`: that is how the visited one shows itself.
template <wire_format F>
constexpr bool is_message(const typename F::packet& p, const expectation<F>& expected, units<F> stream) {
    if (!(p.envelope() == expected.envelope) || p.index() >= F::messages::count || !expected.decodes(p)) return false;
    bool visited = false;
    const error why = visit<F>(p, [&](const auto& m) {
        page<F> out;
        const auto size = F::encode_unchecked(p.envelope(), m, out.all);
        visited = size && std::ranges::equal(units<F>(out.all).first(*size), stream);
    });
    return !why && visited;
}

/// The first chunk of a stream and all others.
struct cuts {
    std::size_t first;
    std::size_t others;
    constexpr std::size_t operator()(std::size_t at) const { return at == 0 ? first : others; }
};

/// Feeds `stream` in chunks; `cut(at)` says how long the chunk that begins at `at` is. Calls `f(event)` for every event,
/// those of the end included. False when the decoder leaves input, miscounts or breaks conservation (L2).
template <wire_format F>
constexpr bool feed(typename F::decoder& d, units<F> stream, auto&& cut, auto&& f) {
    std::uint64_t covered = 0, packets = 0, errors = 0;
    const auto take = [&](units<F>& in) {
        for (;;) {
            const auto event = d.next(in);
            if (event.code == errc::need_more) return;
            covered += event.length;
            ++(event.code == errc::ok ? packets : errors);
            f(event);
        }
    };
    for (std::size_t at = 0; at < stream.size();) {
        const std::size_t n = std::min(cut(at), stream.size() - at);
        units<F> in = stream.subspan(at, n);
        take(in);
        at += n;
        if (!in.empty() || covered + d.pending() + d.counters().foreign != at) return false;
    }
    d.finish();
    units<F> none{};
    take(none);
    std::uint64_t counted = 0;
    for (const std::uint64_t n : d.counters().errors) counted += n;
    return d.pending() == 0 && covered + d.counters().foreign == stream.size() && d.counters().packets == packets && counted == errors;
}

/// Fed in such chunks, `stream` gives exactly one event: the message, from its first unit to its last.
template <wire_format F>
constexpr bool decodes_to(const expectation<F>& expected, units<F> stream, cuts cut) {
    typename F::decoder d;
    std::size_t seen = 0;
    bool good = true;
    const bool whole = feed<F>(d, stream, cut, [&](const auto& event) {
        good = good && event.code == errc::ok && event.offset == 0 && event.length == stream.size() && is_message<F>(event.packet, expected, stream);
        ++seen;
    });
    return whole && good && seen == 1;
}

/// As `decodes_to`, whatever the chunk size; `stride` thins the sizes out: static_asserts pass a coarse one, clang stops after 2^20 steps.
template <wire_format F>
constexpr bool decodes_in_chunks(const expectation<F>& expected, units<F> stream, std::size_t stride = 1) {
    for (std::size_t chunk = 1; chunk < stream.size(); chunk += stride)
        if (!decodes_to<F>(expected, stream, cuts{chunk, chunk})) return false;
    return decodes_to<F>(expected, stream, cuts{stream.size(), stream.size()});
}

/// As `decodes_to`, cut in two at every `stride`-th place.
template <wire_format F>
constexpr bool decodes_at_splits(const expectation<F>& expected, units<F> stream, std::size_t stride = 1) {
    for (std::size_t split = 1; split < stream.size(); split += stride)
        if (!decodes_to<F>(expected, stream, cuts{split, stream.size()})) return false;
    return true;
}

/// decode(encode(m)) == m, in chunks of every `stride`-th size.
template <wire_format F, class M>
constexpr bool round_trips(const typename F::envelope& e, const M& m, std::size_t stride = 1) {
    page<F> out;
    const auto size = F::encode(e, m, std::span(out.all).first(F::max_units));
    return size && decodes_in_chunks<F>(expected_message<F, M>(e, m), units<F>(out.all).first(*size), stride);
}

/// As `round_trips`, for messages with violations: the encoder refuses them by `field`, its unchecked twin writes them.
template <wire_format F, class M>
constexpr bool round_trips_unchecked(const typename F::envelope& e, const M& m, field_ref field) {
    page<F> out;
    const auto refused = F::encode(e, m, out.all);
    if (refused || refused.error() != error{errc::out_of_range, field} || !out.untouched_from(0)) return false;
    const auto size = F::encode_unchecked(e, m, std::span(out.all).first(F::max_units));
    return size && decodes_to<F>(expected_message<F, M>(e, m), units<F>(out.all).first(*size), cuts{*size, *size});
}

}  // namespace trama::properties
