#pragma once
// What the harness has to know about daisy beyond the wire_format concept.
#include "random_message.hpp"
#include "trama/daisy/format.hpp"
#include "traits.hpp"

namespace trama::fuzz {

template <>
struct traits<daisy::format> : octet_traits {
    /// An intact documented packet that begins so many bytes after the last damaged one is delivered.
    static constexpr std::size_t recovery_bound = 256;
    static constexpr bool one_spelling = true;  ///< A message has but one body.

    /// Addresses under which `M` means what it means; board 15 as source only when `strange`.
    template <class M>
    static daisy::envelope envelope_for(dice& d, bool strange = false) {
        const auto family = daisy::family_of(M::key);
        const bool response = (daisy::command_of(M::key) & daisy::response_bit) != 0;
        const auto far = static_cast<unsigned>(d.below(7));
        unsigned near = static_cast<unsigned>(d.below(7));
        if (family != daisy::family::common) {
            near = static_cast<unsigned>(family);
            if (family == daisy::family::battery_controller && d.one_in(3)) near = 6;
        }
        daisy::address owner = daisy::board(near, static_cast<unsigned>(d.below(response ? 15 : 16)));
        daisy::address other = daisy::board(far, static_cast<unsigned>(d.below(response ? 16 : 15)));
        if (family == daisy::family::common && !response && d.one_in(8)) owner = daisy::everyone;
        // A board reports to the main controller: the group of the other end then tells the family.
        if (family != daisy::family::common && d.one_in(4)) {
            other = daisy::board(near, other.id());
            owner = daisy::board(0, owner.id());
        }
        daisy::envelope e = response ? daisy::envelope{other, owner} : daisy::envelope{owner, other};
        if (strange && d.one_in(2)) e.source.octet |= 0x0F;
        return e;
    }
    /// Whether the packet tells a decoder by itself that it is in step; texts, rejected packets and packets from groups
    /// that the document does not know may be noise that looks like one.
    template <class M>
    static bool evident(const daisy::envelope& e, const M& m) {
        if (e.source.group() > 6 || (e.destination.group() > 6 && e.destination != daisy::everyone)) return false;
        if constexpr (requires { m.evident(); }) return m.evident();
        else return true;
    }
    /// A window that could be taken for a packet: the laws of recovery speak only of traffic without such.
    static bool could_be_packet(std::span<const std::uint8_t> at) {
        if (at.size() < 5 || at[0] < 4 || at.size() < std::size_t{at[0]} + 1) return false;
        std::uint8_t x = 0;
        for (std::size_t i = 0; i != std::size_t{at[0]} + 1; ++i) x ^= at[i];
        return x == 0 && (at[1] < 0x70 || at[1] == 0xFF) && at[2] < 0x70 && (at[3] & 0x30) == 0;
    }
};

}  // namespace trama::fuzz
