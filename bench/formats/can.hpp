#pragma once
#include "tasks.hpp"
#include "traffic.hpp"
#include "trama/can/format.hpp"

namespace trama::bench {

template <>
struct traits<can::format> {
    [[gnu::always_inline]] static std::uint64_t word_of_envelope(const can::packet& p) { return p.envelope().id; }
    [[gnu::always_inline]] static std::uint64_t two_fields(const can::packet& p) {
        const auto v = view_as<can::actuator_state>(p);
        return v ? std::uint64_t{*v->get<&can::actuator_state::actuator>()} + *v->get<&can::actuator_state::state>() : 0;
    }
    static void damage(can::frame& f, dice& d) { f.length = static_cast<std::uint8_t>(d.below(9)); }
    template <class M>
    static can::envelope addresses(dice& d) { return {static_cast<std::uint32_t>(can::central_master + d.below(3))}; }
};

/// Of a frame that is read back.
inline std::uint64_t content_of(const can::frame& f) { return load_le<std::uint64_t>(f.data.data()) * 31 + f.id * 9 + f.length; }

namespace can_code {
using frames_in = unit_span<can::format>;

tally walk(frames_in in);         ///< The bare frame walk: identifier, DLC and data of each frame.
tally typed_maps(frames_in in);   ///< A map of vectors, a variant.
tally typed_slots(frames_in in);  ///< Fixed slots and a switch.
}  // namespace can_code

void add_can(std::vector<entry>& all, const scale& sizes);

}  // namespace trama::bench
