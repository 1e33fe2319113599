#pragma once
// daisy as a subject of the laws.

#include "laws/byte_subject.hpp"
#include "reference/reference.hpp"
#include "trama/daisy/format.hpp"

namespace trama::test {

/// A packet with a good CRC around any header and data.
inline octets sealed(std::uint8_t destination, std::uint8_t source, std::uint8_t command, const octets& data) {
    octets packet{static_cast<std::uint8_t>(data.size() + 4), destination, source, command};
    append(packet, data);
    packet.push_back(xor_of(packet));
    return packet;
}

template <>
struct subject<daisy::format> : byte_subject {
    using F = daisy::format;

    static daisy::decoder make_decoder() { return {}; }
    static std::string head(const daisy::event& e) {
        return text_of([&](text_sink& out) { out << R"({"protocol":"daisy","offset":)" << e.offset << ",\"length\":" << e.length; });
    }
    static std::span<const std::uint8_t> raw(const daisy::event& e) { return e.packet.bytes(); }
    template <has_layout M>
    static std::string identity(const daisy::event& e) {
        return text_of([&](text_sink& out) {
            out << ",\"destination\":" << e.packet.envelope().destination.octet << ",\"source\":" << e.packet.envelope().source.octet << ",\"message\":";
            out.quoted(M::name) << ",\"kind\":" << (e.packet.response() ? "\"response\"" : "\"request\"");
        });
    }
    static std::string error_tail(const daisy::event& e) {
        return text_of([&](text_sink& out) {
            if (e.code == errc::bad_checksum) out << ",\"expected\":" << e.expected << ",\"received\":" << e.received;
            if (e.code != errc::unknown_message) return;
            out << ",\"destination\":" << e.packet.envelope().destination.octet << ",\"source\":" << e.packet.envelope().source.octet;
            out << ",\"command\":" << e.packet.command();
        });
    }
    static std::vector<std::string> reference_lines(std::span<const std::uint8_t> stream, std::span<const std::size_t> idle_at = {}) {
        return trama_reference::daisy_lines(stream, idle_at);
    }

    /// Addresses under which `M` means what it means; a source that is everyone only if wild.
    template <has_layout M>
    static daisy::envelope random_envelope(rng& random, manners how) {
        const auto family = daisy::family_of(M::key);
        const bool response = (daisy::command_of(M::key) & daisy::response_bit) != 0;
        unsigned group = static_cast<unsigned>(family == daisy::family::common ? random.below(7) : static_cast<std::size_t>(family));
        if (family == daisy::family::battery_controller && random.one_in(2)) group = 6;
        auto near = daisy::board(group, static_cast<unsigned>(random.below(response ? 15 : 16)));
        auto far = daisy::board(random.one_in(2) ? 0 : static_cast<unsigned>(random.below(7)), static_cast<unsigned>(random.below(15)));
        if (family == daisy::family::common && !response && random.one_in(6)) near = daisy::everyone;
        if (far.group() == 0 && random.one_in(2) && near != daisy::everyone && near.id() != 15) std::swap(near, far);
        daisy::envelope e = response ? daisy::envelope{far, near} : daisy::envelope{near, far};
        if (how == manners::wild && random.one_in(8)) e.source.octet |= 0x0F;
        return e;
    }

    static octets undocumented(rng& random) {
        const octets data = random.bytes(random.one_in(10) ? random.below(252) : random.below(9));
        if (random.one_in(3)) return sealed(static_cast<std::uint8_t>(random.within(0x70, 0xFE)), static_cast<std::uint8_t>(random.below(0x70)), static_cast<std::uint8_t>(random.below(0x48)), data);
        return sealed(static_cast<std::uint8_t>(random.below(0x70)), static_cast<std::uint8_t>(random.below(0x70)), random.byte(), data);
    }
    /// A text or an error packet with packets, whole or broken, inside.
    static octets nested(rng& random) {
        octets inside;
        while (inside.size() < 200 && (inside.empty() || !random.one_in(2))) {
            octets one = random_units<F>(random, manners::wild);
            if (random.one_in(4)) damage(random, one, 1, [&](auto& b) { change(random, b); });
            append(inside, one);
        }
        inside.resize(std::min<std::size_t>(inside.size(), 240));
        const auto destination = static_cast<std::uint8_t>(random.below(0x70)), source = static_cast<std::uint8_t>(random.below(0x70));
        if (random.one_in(2)) return sealed(destination, source, static_cast<std::uint8_t>(0x81 + random.below(2)), inside);
        octets data{0};
        append(data, inside);
        data.push_back(random.one_in(2) || inside.empty() ? random.byte() : xor_of(std::span(inside).first(inside.size() - 1)));
        return sealed(destination, source, 4, data);
    }
    /// Bytes that make headers likely.
    static octets tempting(rng& random, std::size_t n) {
        constexpr std::array<std::uint8_t, 27> alphabet{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0x11, 0x31, 0x40, 0x43, 0x44, 0x81, 0x84, 0xC3, 0xC4, 0xFF, 0x20};
        octets all(n);
        for (auto& b : all) b = alphabet[random.below(alphabet.size())];
        return all;
    }
    static octets piece(rng& random, traffic kind) {
        switch (kind) {
            case traffic::clean: return random_units<F>(random, random.one_in(3) ? manners::wild : manners::valid);
            case traffic::garbage: return random.bytes(random.within(1, 40));
            default: break;
        }
        switch (random.below(kind == traffic::hostile ? 7 : 12)) {
            case 0: return undocumented(random);
            case 1: return nested(random);
            case 2: case 3: return kind == traffic::hostile ? tempting(random, random.within(1, 60)) : undocumented(random);
            default: return random_units<F>(random, manners::wild);
        }
    }
    static octets random_stream(rng& random, traffic kind, std::size_t size) {
        octets stream;
        if (kind == traffic::periodic) {
            octets cycle;
            while (cycle.empty() || (cycle.size() < size / 8 && !random.one_in(5))) append(cycle, piece(random, random.one_in(3) ? traffic::damaged : traffic::clean));
            while (stream.size() < size) append(stream, cycle);
            stream.erase(stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(random.below(cycle.size())));
        }
        while (stream.size() < size) append(stream, piece(random, kind));
        if (kind == traffic::damaged || kind == traffic::hostile) damage(random, stream, random.below(1 + size / 40), [&](auto& b) { change(random, b); });
        if (kind == traffic::periodic && random.one_in(2)) damage(random, stream, 1, [&](auto& b) { change(random, b); });
        return stream;
    }
};

extern template std::vector<daisy::format::unit> random_units<daisy::format>(rng&, manners);
extern template std::string line_of<daisy::format>(const daisy::event&);

}  // namespace trama::test
