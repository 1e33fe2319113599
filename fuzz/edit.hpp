#pragma once
// Pieces of input, counted in units: what every mutator does with octets.
#include <algorithm>

#include "traits.hpp"

namespace trama::fuzz {

inline octets piece_of(std::span<const std::uint8_t> input, std::size_t begin, std::size_t size) {
    const auto part = input.subspan(begin, size);
    return {part.begin(), part.end()};
}
inline void insert(octets& input, std::size_t at, std::span<const std::uint8_t> piece) {
    input.insert(input.begin() + static_cast<std::ptrdiff_t>(at), piece.begin(), piece.end());
}
inline void erase(octets& input, std::size_t at, std::size_t size) {
    input.erase(input.begin() + static_cast<std::ptrdiff_t>(at), input.begin() + static_cast<std::ptrdiff_t>(at + size));
}
/// Puts what was made where an engine wants it, cut to its limit.
inline std::size_t hand_over(std::span<const std::uint8_t> made, std::uint8_t* out, std::size_t max_size) {
    const auto kept = made.first(std::min(made.size(), max_size));
    std::copy(kept.begin(), kept.end(), out);
    return kept.size();
}

/// Where some unit of `input` begins, or where the last one ends.
template <class F>
std::size_t some_boundary(std::span<const std::uint8_t> input, dice& d) {
    constexpr std::size_t each = traits<F>::unit_octets;
    return d.below(input.size() / each + 1) * each;
}

/// Flips a bit in one unit of `piece`, drops or doubles one.
template <class F>
void break_somewhere(octets& piece, dice& d) {
    constexpr std::size_t each = traits<F>::unit_octets;
    if (piece.size() < each) return;
    const std::size_t at = d.below(piece.size() / each) * each, octet = at + d.below(each);
    switch (d.below(3)) {
        case 0: piece[octet] = static_cast<std::uint8_t>(piece[octet] ^ 1U << d.below(8)); break;
        case 1: erase(piece, at, each); break;
        default: insert(piece, at, piece_of(piece, at, each));
    }
}

/// Changes what stands around the body of a message, and mends what depends on it: for can, of one of its frames.
template <class F>
void alter(octets& piece, dice& d) {
    constexpr std::size_t each = traits<F>::unit_octets;
    if (piece.size() < each) return;
    if constexpr (requires { traits<F>::alter_unit(std::span(piece), d); }) traits<F>::alter_unit(std::span(piece).subspan(d.below(piece.size() / each) * each, each), d);
    else if constexpr (requires { traits<F>::alter(piece, d); }) traits<F>::alter(piece, d);
}

/// Loses, doubles, swaps or moves up to three units of `input`, or changes how one comes, whatever they belong to.
template <class F>
void shuffle_units(octets& input, dice& d) {
    constexpr std::size_t each = traits<F>::unit_octets;
    const std::size_t count = input.size() / each;
    if (count == 0) return;
    const std::size_t first = d.below(count), run = 1 + d.below(std::min<std::size_t>(3, count - first));
    const octets piece = piece_of(input, first * each, run * each);
    // Mostly near by: a message is but a few units long.
    const auto elsewhere = [&](std::size_t places) { return (d.one_in(2) ? d.below(places) : std::min(places - 1, first + d.below(4))) * each; };
    switch (d.below(5)) {
        case 0: erase(input, first * each, run * each); break;
        case 1: insert(input, elsewhere(count + 1), piece); break;
        case 2: {
            const std::size_t other = elsewhere(count);
            std::swap_ranges(input.begin() + static_cast<std::ptrdiff_t>(other), input.begin() + static_cast<std::ptrdiff_t>(other + each), input.begin() + static_cast<std::ptrdiff_t>(first * each));
            break;
        }
        case 3:
            erase(input, first * each, run * each);
            insert(input, elsewhere(count - run + 1), piece);
            break;
        default:
            if constexpr (requires { traits<F>::alter_unit(std::span(input), d); }) traits<F>::alter_unit(std::span(input).subspan(first * each, each), d);
            else break_somewhere<F>(input, d);
    }
}

/// Puts the units of `piece` between those of `input`, from `at` on, in their order.
template <class F>
void interleave(octets& input, std::size_t at, std::span<const std::uint8_t> piece, dice& d) {
    constexpr std::size_t each = traits<F>::unit_octets;
    for (; piece.size() >= each; piece = piece.subspan(each)) {
        insert(input, at, piece.first(each));
        at = std::min(at + each * (1 + d.below(3)), input.size() / each * each);
    }
}

}  // namespace trama::fuzz
