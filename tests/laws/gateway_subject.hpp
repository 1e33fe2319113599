#pragma once
// gateway as a subject of the laws.

#include "laws/byte_subject.hpp"
#include "reference/reference.hpp"
#include "trama/gateway/format.hpp"

namespace trama::test {

template <>
struct subject<gateway::format> : byte_subject {
    using F = gateway::format;

    static gateway::decoder make_decoder() { return {}; }
    static std::string head(const gateway::event& e) {
        return text_of([&](text_sink& out) { out << R"({"protocol":"gateway","offset":)" << e.offset << ",\"length\":" << e.length; });
    }
    static std::span<const std::uint8_t> raw(const gateway::event& e) { return e.packet.bytes(); }
    template <has_layout M>
    static std::string identity(const gateway::event&) { return ",\"message\":\"" + std::string(M::name) + '"'; }
    static std::string error_tail(const gateway::event& e) {
        if (e.code == errc::bad_number) return ",\"field\":\"type\"";
        if (e.code == errc::unknown_message) return ",\"type\":" + std::to_string(e.packet.type());
        return {};
    }
    static std::vector<std::string> reference_lines(std::span<const std::uint8_t> stream, std::span<const std::size_t> = {}) {
        return trama_reference::gateway_lines(stream);
    }
    template <has_layout M>
    static gateway::envelope random_envelope(rng&, manners) { return {}; }

    /// A record with numbers on either side of their columns.
    static octets record(rng& random, manners how) {
        octets out(gateway::max_record);
        memory views;
        F::messages::at(random.below(F::messages::count), [&]<class M>() {
            const auto side = random.one_in(2) ? gateway::justify::left : gateway::justify::right;
            out.resize(*F::encode_unchecked({}, random_message<M>(random, how, views), out, side));
        });
        return out;
    }
    /// As a record, with some characters that numbers may or may not hold.
    static octets scribbled(rng& random) {
        constexpr std::string_view characters = "0123456789   --..+eE,x";
        octets r = record(random, manners::wild);
        for (std::size_t n = random.within(1, 4); n != 0; --n) r[random.within(1, r.size() - 2)] = static_cast<std::uint8_t>(characters[random.below(characters.size())]);
        return r;
    }
    /// A payload of any length between the delimiters, or without one of them.
    static octets odd(rng& random) {
        octets r{gateway::stx};
        const std::size_t n = random.one_in(4) ? random.within(200, 300) : random.below(40);
        for (std::size_t i = 0; i != n; ++i) r.push_back(static_cast<std::uint8_t>(i < 3 && !random.one_in(5) ? random.within('0', '2') : random.within(0x20, 0x7E)));
        if (random.one_in(4)) r[random.below(r.size())] = random.byte();
        if (!random.one_in(4)) r.push_back(gateway::etx);
        return r;
    }
    static octets piece(rng& random, traffic kind) {
        if (kind == traffic::clean || kind == traffic::periodic) return record(random, random.one_in(3) ? manners::wild : manners::valid);
        if (kind == traffic::garbage) return random.bytes(random.within(1, 40));
        switch (random.below(kind == traffic::hostile ? 5 : 9)) {
            case 0: return odd(random);
            case 1: return scribbled(random);
            case 2: {
                constexpr std::array<std::uint8_t, 6> marks{gateway::stx, gateway::etx, ' ', '1', 0x7F, 0x80};
                octets some(random.within(1, 20));
                for (auto& b : some) b = marks[random.below(marks.size())];
                return some;
            }
            default: return record(random, manners::wild);
        }
    }
    static octets random_stream(rng& random, traffic kind, std::size_t size) {
        octets stream;
        while (stream.size() < size) append(stream, piece(random, kind));
        if (kind == traffic::damaged || kind == traffic::hostile) damage(random, stream, random.below(1 + size / 60), [&](auto& b) { change(random, b); });
        return stream;
    }
};

extern template std::vector<gateway::format::unit> random_units<gateway::format>(rng&, manners);
extern template std::string line_of<gateway::format>(const gateway::event&);

}  // namespace trama::test
