#pragma once
// Mutations of a stream that know the schema: whole messages come, go, double, move, mingle, or get one value or their
// surroundings changed with LEN, CRC and padding mended. One in eight of them is broken afterwards. The rest is libFuzzer's own.
#include "edit.hpp"
#include "random_message.hpp"
#include "samples.hpp"

namespace trama::fuzz {

/// Where the units of a known message lie in the input, in octets; those of others may lie between them.
using place = std::vector<std::size_t>;

template <wire_format F>
std::vector<place> places_of(std::span<const std::uint8_t> input) {
    std::vector<place> places;
    const auto units = traits<F>::units_from(input);
    typename F::decoder decoder;
    read<F>(decoder, units, [&](const auto& e) {
        if (e.code != errc::ok) return;
        place& p = places.emplace_back(units_of<F>(units, e));
        for (std::size_t& at : p) at *= traits<F>::unit_octets;
    });
    return places;
}

/// The units of a message, run together.
template <wire_format F>
octets gather(std::span<const std::uint8_t> input, const place& p) {
    octets piece;
    for (const std::size_t at : p) insert(piece, piece.size(), input.subspan(at, traits<F>::unit_octets));
    return piece;
}
/// Puts `piece` where the message at `p` was: unit by unit, and what is left over behind the last one.
template <wire_format F>
void put_back(octets& input, const place& p, std::span<const std::uint8_t> piece) {
    constexpr std::size_t each = traits<F>::unit_octets;
    const std::size_t both = std::min(p.size(), piece.size() / each);
    for (std::size_t i = 0; i != both; ++i) std::copy_n(piece.begin() + static_cast<std::ptrdiff_t>(i * each), each, input.begin() + static_cast<std::ptrdiff_t>(p[i]));
    if (!p.empty()) insert(input, p.back() + each, piece.subspan(both * each));
    for (std::size_t i = p.size(); i != both; --i) erase(input, p[i - 1], each);
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

/// The message in `piece` with one value changed and everything that depends on it mended; `piece` itself when it is none.
template <wire_format F>
octets changed(const octets& piece, dice& d) {
    octets out = piece;
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
    if constexpr (requires { traits<F>::arrive_like(std::span(out), std::span(piece)); })
        for (std::size_t at = 0; at < std::min(out.size(), piece.size()); at += traits<F>::unit_octets)
            traits<F>::arrive_like(std::span(out).subspan(at), std::span(piece).subspan(at));
    return out;
}

/// A new message comes, whole or between the units of others.
template <wire_format F>
void add_message(octets& input, std::size_t at, dice& d) {
    octets piece = random_wire<F>(d);
    if (d.one_in(4)) alter<F>(piece, d);
    if (d.one_in(8)) break_somewhere<F>(piece, d);
    if (traits<F>::unit_octets > 1 && d.one_in(2)) interleave<F>(input, at, piece, d);
    else insert(input, at, piece);
}

/// One message of the input changes, doubles, moves or goes.
template <wire_format F>
void edit_message(octets& input, const place& chosen, std::size_t elsewhere, dice& d) {
    octets piece = gather<F>(input, chosen);
    const std::size_t action = d.below(10);
    if (action < 4) piece = changed<F>(piece, d);
    else if (action < 6) alter<F>(piece, d);
    if (d.one_in(8)) break_somewhere<F>(piece, d);
    if (action < 6) {
        put_back<F>(input, chosen, piece);
    } else {
        if (action == 9) piece.clear();
        if (action > 7) put_back<F>(input, chosen, {});
        insert(input, std::min(elsewhere, input.size()), piece);
    }
}

/// libFuzzer's own mutations: of the whole input, or where a unit has several octets, mostly inside one, so that the rest keeps its footing.
template <wire_format F>
std::size_t mutate_octets(std::uint8_t* data, std::size_t size, std::size_t max_size, dice& d) {
    constexpr std::size_t each = traits<F>::unit_octets;
    if (each == 1 || size < each || d.one_in(4)) return LLVMFuzzerMutate(data, size, max_size);
    std::uint8_t* unit = data + d.below(size / each) * each;
    const std::size_t left = LLVMFuzzerMutate(unit, each, each);
    std::fill(unit + left, unit + each, std::uint8_t{0});
    return size;
}

template <wire_format F>
std::size_t mutate(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    dice d(seed);
    if (plain_octets()) return LLVMFuzzerMutate(data, size, max_size);
    if (d.one_in(3)) return mutate_octets<F>(data, size, max_size, d);
    octets input(data, data + size);
    if (d.one_in(traits<F>::unit_octets > 1 ? 4 : 12)) {
        shuffle_units<F>(input, d);
        return hand_over(input, data, max_size);
    }
    const auto places = places_of<F>(input);
    std::size_t boundary = some_boundary<F>(input, d);
    if (!places.empty() && !d.one_in(8)) boundary = places[d.below(places.size())].front();
    if (places.empty() || d.one_in(3)) add_message<F>(input, boundary, d);
    else edit_message<F>(input, places[d.below(places.size())], boundary, d);
    return hand_over(input, data, max_size);
}

/// The front of one input and the back of the other, cut where messages begin and end.
template <wire_format F>
std::size_t cross(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::uint8_t* out, std::size_t max_size, unsigned seed) {
    dice d(seed);
    const auto front = places_of<F>(a), back = places_of<F>(b);
    const bool plain = plain_octets();
    const std::size_t end = plain ? d.below(a.size() + 1) : front.empty() ? some_boundary<F>(a, d) : front[d.below(front.size())].back() + traits<F>::unit_octets;
    const std::size_t begin = plain ? d.below(b.size() + 1) : back.empty() ? some_boundary<F>(b, d) : back[d.below(back.size())].front();
    octets input = piece_of(a, 0, end);
    insert(input, input.size(), b.subspan(begin));
    return hand_over(input, out, max_size);
}

}  // namespace trama::fuzz
