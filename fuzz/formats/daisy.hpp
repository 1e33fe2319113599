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
    /// Whether the packet tells a decoder by itself that it is in step; texts, rejected packets, packets from groups that
    /// the document does not know and calls to everyone that not every family has may be noise that looks like one.
    template <class M>
    static bool evident(const daisy::envelope& e, const M& m) {
        const bool everyone_called = e.destination == daisy::everyone && daisy::family_of(M::key) == daisy::family::common;
        if (e.source.group() > 6 || (e.destination.group() > 6 && !everyone_called)) return false;
        if constexpr (requires { m.description; }) return all_printable(m.description.bytes().data(), m.description.size());  // a packet in it would have a tab or worse
        else if constexpr (requires { m.evident(); }) return m.evident();
        else return true;
    }
    /// A ping from the main controller to the first motor board. [daisy §4]
    static octets landmark() { return {0x04, 0x10, 0x00, 0x03, 0x17}; }
    /// One with an address that the document does not know is refused where it holds a packet that the document does know.
    static bool arrives(std::span<const std::uint8_t> packet) { return packet[1] < 0x70 && packet[2] < 0x70; }
    /// LEN and CRC as the rest of the packet asks for.
    static void mend(octets& packet) {
        packet[0] = static_cast<std::uint8_t>(packet.size() - 1);
        packet.back() = 0;
        packet.back() = daisy::checksum(packet);
    }
    /// The packet with another body; empty when LEN cannot say how long that is.
    static octets with_body(std::span<const std::uint8_t> packet, std::span<const std::uint8_t> body) {
        if (body.size() > 255 - daisy::header_size) return {};
        octets out(packet.begin(), packet.begin() + daisy::header_size);
        out.insert(out.end(), body.begin(), body.end());
        out.push_back(0);
        mend(out);
        return out;
    }
    /// Another packet with a good CRC, documented or not: an address or the command changed, the body cut, lengthened or
    /// the packet itself, or LEN alone, so that a shorter packet is intact and the rest noise.
    static void alter(octets& packet, dice& d) {
        if (packet.size() < daisy::min_packet) return;
        octets body(packet.begin() + daisy::header_size, packet.end() - 1);
        const std::size_t kind = d.below(6);
        if (kind < 3) {
            packet[1 + kind] = static_cast<std::uint8_t>(d.one_in(2) ? d.next() : packet[1 + kind] ^ 1U << d.below(8));
            mend(packet);
        } else if (kind == 3) {
            const std::size_t rest = packet.size() - daisy::min_packet;
            packet[0] = static_cast<std::uint8_t>(daisy::header_size + d.below(rest));
            packet[packet[0]] = daisy::checksum(std::span(packet).first(packet[0]));
        } else {
            if (kind == 4) body = packet;
            else if (d.one_in(2)) body.resize(body.size() - std::min(body.size(), 1 + d.below(4)));
            else body.resize(body.size() + 1 + d.below(d.one_in(16) ? 255 : 4), static_cast<std::uint8_t>(d.next()));
            if (const octets other = with_body(packet, body); !other.empty()) packet = other;
        }
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
