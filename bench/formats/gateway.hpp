#pragma once
#include "tasks.hpp"
#include "traffic.hpp"
#include "trama/gateway/format.hpp"

namespace trama::bench {

template <>
struct traits<gateway::format> {
    using chosen = gateway::cart_state;  ///< Which cart, and where it goes next.
    static constexpr auto first = &chosen::cart_id;
    static constexpr auto second = &chosen::next_node;
    static constexpr std::size_t chunks[] = {0, 65536, 1460, 64, 7, 1};
    static constexpr const char* clean_name = "trama, clean records";

    [[gnu::always_inline]] static void each_envelope_word(gateway::envelope, auto&&) {}
    /// A pass that looks for forbidden bytes.
    static void add_limits(race& r, const shared_stream<gateway::format>& s, task t, bool clean);
    /// The library, as it is timed.
    static std::array<library_task<gateway::format>, std::size(all_tasks)> library();
    /// The typical code and the good one.
    static std::span<const by_hand_code<gateway::format>> by_hand();
    static void damage(std::uint8_t& b, dice& d) { b = static_cast<std::uint8_t>(b ^ 1U << d.below(8)); }
    template <class M>
    static gateway::envelope addresses(dice&) { return {}; }
};

/// The traffic of a client and its gateway, both ways, as one would record it.
stream<gateway::format> gateway_session(std::size_t bytes);

void add_gateway(std::vector<entry>& all, const scale& sizes);
void add_gateway_encode(std::vector<entry>& all, const scale& sizes);

}  // namespace trama::bench
