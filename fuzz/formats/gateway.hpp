#pragma once
// What the harness has to know about gateway beyond the wire_format concept.
#include "random_message.hpp"
#include "traits.hpp"
#include "trama/gateway/format.hpp"

namespace trama::fuzz {

template <>
struct traits<gateway::format> : octet_traits {
    /// No fault may cost an intact record: STX always begins one.
    static constexpr std::size_t recovery_bound = 0;
    static constexpr bool one_spelling = false;  ///< A message has but one body.

    template <class M>
    static gateway::envelope envelope_for(dice&, bool = false) { return {}; }
    template <class M>
    static bool evident(const gateway::envelope&, const M&) { return true; }
    static bool could_be_packet(std::span<const std::uint8_t>) { return false; }
};

}  // namespace trama::fuzz
