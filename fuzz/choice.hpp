#pragma once
// Input for `decode`: the first octet chooses a message, the rest is its body.
#include <algorithm>

#include "support.hpp"
#include "trama/core/layout.hpp"

namespace trama::fuzz {

/// Where the message that `choice` means stands in the list.
template <class F>
std::size_t chosen(std::uint8_t choice) {
    static_assert(F::messages::count <= 0x80);
    return (choice & 0x7FU) % F::messages::count;
}

/// Calls `f.operator()<M>()` for the message that `choice` means.
template <class F>
void at_choice(std::uint8_t choice, auto&& f) {
    F::messages::at(chosen<F>(choice), f);
}

/// The body in `input`: cut or filled to the right size on request. At most 1024 octets, several times what any packet holds.
template <class M>
octets body_in(std::span<const std::uint8_t> input) {
    const auto rest = input.subspan(1, std::min<std::size_t>(input.size() - 1, 1024));
    octets body(rest.begin(), rest.end());
    if (M::layout.fixed && (input[0] & 0x80) != 0) body.resize(M::layout.size, ' ');
    return body;
}

}  // namespace trama::fuzz
