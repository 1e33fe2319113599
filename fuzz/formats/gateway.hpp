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
    static constexpr gateway::justify other_spelling = gateway::justify::left;

    template <class M>
    static gateway::envelope envelope_for(dice&, bool = false) { return {}; }
    template <class M>
    static bool evident(const gateway::envelope&, const M&) { return true; }
    /// The record with other columns behind its type.
    static octets with_body(std::span<const std::uint8_t> record, std::span<const std::uint8_t> body) {
        octets out(record.begin(), record.begin() + 1 + gateway::type_size);
        out.insert(out.end(), body.begin(), body.end());
        out.push_back(gateway::etx);
        return out;
    }
    /// Another record between the same STX and ETX: of another type, known or not, spelled in another way, or of another length.
    static void alter(octets& record, dice& d) {
        constexpr std::size_t begin = 1 + gateway::type_size;
        if (record.size() <= begin) return;
        const std::size_t kind = d.below(4);
        if (kind == 0) {
            for (std::size_t i = 1, rest = d.below(300); i != begin; ++i, rest /= 10) record[begin - i] = static_cast<std::uint8_t>(rest == 0 && i != 1 ? ' ' : '0' + rest % 10);
        } else if (kind == 1) {
            record[1 + d.below(gateway::type_size)] = static_cast<std::uint8_t>(" 0123456789-"[d.below(12)]);
        } else if (kind == 2) {
            std::rotate(record.begin() + 1, record.begin() + 2 + static_cast<std::ptrdiff_t>(d.below(2)), record.begin() + begin);
        } else {
            octets body(record.begin() + begin, record.end() - 1);
            body.resize(d.one_in(2) ? body.size() - std::min(body.size(), 1 + d.below(4)) : body.size() + 1 + d.below(d.one_in(16) ? gateway::max_payload : 4), ' ');
            record = with_body(record, body);
        }
    }
    static bool could_be_packet(std::span<const std::uint8_t>) { return false; }
};

}  // namespace trama::fuzz
