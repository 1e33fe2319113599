#pragma once
#include "tasks.hpp"
#include "traffic.hpp"
#include "trama/gateway/format.hpp"

namespace trama::bench {

template <>
struct traits<gateway::format> {
    [[gnu::always_inline]] static std::uint64_t word_of_envelope(const gateway::packet&) { return 0; }
    /// Which cart, and where it goes next.
    [[gnu::always_inline]] static std::uint64_t two_fields(const gateway::packet& p) {
        using gateway::cart_state;
        const auto v = view_as<cart_state>(p);
        if (!v) return 0;
        return v->get<&cart_state::cart_id>().value_or(0) + std::uint64_t{v->get<&cart_state::next_node>().value_or(0)};
    }
    static void damage(std::uint8_t& b, dice& d) { b = static_cast<std::uint8_t>(b ^ 1U << d.below(8)); }
    template <class M>
    static gateway::envelope addresses(dice&) { return {}; }
};

namespace gateway_code {
using bytes_in = unit_span<gateway::format>;

tally framing_strings(bytes_in in);   ///< A byte-wise state machine that fills a std::string.
tally framing_pointers(bytes_in in);  ///< memchr for the delimiters, a loop over the characters.
template <bool Validate>
tally typed_strings(bytes_in in);     ///< Every field by substr, trim and stoull.
template <bool Validate>
tally typed_pointers(bytes_in in);    ///< Every field by trimming in place and from_chars.
}  // namespace gateway_code

void add_gateway(std::vector<entry>& all, const scale& sizes);
void add_gateway_encode(std::vector<entry>& all, const scale& sizes);

}  // namespace trama::bench
