#pragma once
// Mutations that know the schema: whole messages come, go, change places, or get one value changed with LEN, CRC and padding
// mended. One in eight of them is broken afterwards. The rest is libFuzzer's own.
#include "random_message.hpp"
#include "samples.hpp"

namespace trama::fuzz {

/// Where a known message lies in the input, in octets.
struct place {
    std::size_t begin = 0, end = 0;
};

/// The messages that lie in one piece; those whose frames interleave with others' are left out.
template <wire_format F>
std::vector<place> places_of(std::span<const std::uint8_t> input) {
    constexpr std::size_t each = traits<F>::unit_octets;
    std::vector<place> places;
    const auto units = traits<F>::units_from(input);
    typename F::decoder decoder;
    std::uint64_t covered = 0;
    read<F>(decoder, units, [&](const auto& e) {
        if (e.code == errc::ok && e.offset >= covered) places.push_back({static_cast<std::size_t>(e.offset) * each, static_cast<std::size_t>(e.offset + e.length) * each});
        covered = std::max(covered, e.offset + e.length);
    });
    return places;
}

template <wire_format F>
octets random_wire(dice& d) {
    octets out;
    F::messages::at(d.below(F::messages::count), [&]<class M>() {
        arena memory;
        M m = random_message<M>(d, memory);
        const bool strange = d.one_in(6);
        if (strange) change_one_value(m, d, memory);
        std::array<typename F::unit, F::max_units> wire{};
        const auto size = F::encode_unchecked(traits<F>::template envelope_for<M>(d, strange), m, wire);
        if (size) out = traits<F>::octets_from(std::span<const typename F::unit>(wire).first(*size));
    });
    return out;
}

template <wire_format F>
sample<F> random_sample(dice& d) {
    sample<F> s;
    while (s.units.empty())
        F::messages::at(d.below(F::messages::count), [&]<class M>() {
            arena memory;
            const M m = random_message<M>(d, memory);
            const auto e = traits<F>::template envelope_for<M>(d);
            if (!traits<F>::evident(e, m)) return;
            std::array<typename F::unit, F::max_units> wire{};
            const auto size = F::encode(e, m, wire);
            require(bool(size), "a valid message encodes");
            s.units.assign(wire.begin(), wire.begin() + static_cast<std::ptrdiff_t>(*size));
            s.body.resize(body_size(m));
            store_body(s.body.data(), m);
        });
    return s;
}

/// The message in `piece` with one value changed and everything that depends on it mended; empty when it is none.
template <wire_format F>
octets changed(std::span<const std::uint8_t> piece, dice& d) {
    octets out;
    const auto units = traits<F>::units_from(piece);
    typename F::decoder decoder;
    read<F>(decoder, units, [&](const auto& e) {
        if (e.code != errc::ok) return;
        (void)visit<F>(e.packet, [&]<class M>(const M& read_only) {
            M m = read_only;
            arena memory;
            change_one_value(m, d, memory);
            std::array<typename F::unit, F::max_units> wire{};
            const auto size = F::encode_unchecked(e.packet.envelope(), m, wire);
            if (size) out = traits<F>::octets_from(std::span<const typename F::unit>(wire).first(*size));
        });
    });
    return out;
}

inline void replace(octets& in, place p, std::span<const std::uint8_t> by) {
    in.erase(in.begin() + static_cast<std::ptrdiff_t>(p.begin), in.begin() + static_cast<std::ptrdiff_t>(p.end));
    in.insert(in.begin() + static_cast<std::ptrdiff_t>(p.begin), by.begin(), by.end());
}

/// Flips, drops or doubles one octet of `piece`.
inline void break_somewhere(octets& piece, dice& d) {
    if (piece.empty()) return;
    const auto at = piece.begin() + static_cast<std::ptrdiff_t>(d.below(piece.size()));
    switch (d.below(3)) {
        case 0: *at = static_cast<std::uint8_t>(*at ^ (1U << d.below(8))); break;
        case 1: piece.erase(at); break;
        default: piece.insert(at, *at);
    }
}

template <wire_format F>
std::size_t mutate(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    dice d(seed);
    if (plain_octets() || d.one_in(3)) return LLVMFuzzerMutate(data, size, max_size);
    octets input(data, data + size);
    const auto places = places_of<F>(input);
    const place chosen = places.empty() ? place{} : places[d.below(places.size())];
    const std::size_t boundary = places.empty() || d.one_in(8) ? d.below(size + 1) : d.one_in(2) ? chosen.begin : chosen.end;
    octets piece;
    place where{boundary, boundary};
    switch (places.empty() ? 0 : d.below(6)) {
        case 0: case 1: piece = random_wire<F>(d); break;
        case 2: case 3:
            piece = changed<F>(std::span(input).subspan(chosen.begin, chosen.end - chosen.begin), d);
            where = chosen;
            break;
        case 4: piece.assign(input.begin() + static_cast<std::ptrdiff_t>(chosen.begin), input.begin() + static_cast<std::ptrdiff_t>(chosen.end)); break;
        default: where = chosen;  // a message lost
    }
    if (d.one_in(8)) break_somewhere(piece, d);
    replace(input, where, piece);
    input.resize(std::min(input.size(), max_size));
    std::copy(input.begin(), input.end(), data);
    return input.size();
}

/// The front of one input and the back of the other, cut where messages begin and end.
template <wire_format F>
std::size_t cross(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::uint8_t* out, std::size_t max_size, unsigned seed) {
    dice d(seed);
    const auto front = places_of<F>(a), back = places_of<F>(b);
    const std::size_t end = front.empty() || plain_octets() ? d.below(a.size() + 1) : front[d.below(front.size())].end;
    const std::size_t begin = back.empty() || plain_octets() ? d.below(b.size() + 1) : back[d.below(back.size())].begin;
    octets input(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(end));
    input.insert(input.end(), b.begin() + static_cast<std::ptrdiff_t>(begin), b.end());
    input.resize(std::min(input.size(), max_size));
    std::copy(input.begin(), input.end(), out);
    return input.size();
}

}  // namespace trama::fuzz
