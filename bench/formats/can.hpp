#pragma once
#include "tasks.hpp"
#include "traffic.hpp"
#include "trama/can/format.hpp"

namespace trama::bench {

template <>
struct traits<can::format> {
    using chosen = can::actuator_state;
    static constexpr auto first = &chosen::actuator;
    static constexpr auto second = &chosen::state;
    static constexpr std::size_t chunks[] = {0, 65536, 1460, 64, sizeof(can::frame)};  ///< A frame is the least that comes.
    static constexpr const char* clean_name = "trama, clean interleaved";

    [[gnu::always_inline]] static void each_envelope_word(can::envelope e, auto&& f) { f(e.id); }
    /// The bare frame walk: identifier, DLC and data of each frame.
    static void add_limits(race& r, const shared_stream<can::format>& s, task t, bool clean);
    /// The library, as it is timed.
    static std::array<library_task<can::format>, std::size(all_tasks)> library();
    /// The typical code and the good one.
    static std::span<const by_hand_code<can::format>> by_hand();
    static void damage(can::frame& f, dice& d) { f.length = static_cast<std::uint8_t>(d.below(9)); }
    template <class M>
    static can::envelope addresses(dice& d) { return {static_cast<std::uint32_t>(can::central_master + d.below(3))}; }
};

/// Of a frame that is read back.
inline std::uint64_t content_of(const can::frame& f) { return load_le<std::uint64_t>(f.data.data()) * 31 + f.id * 9 + f.length; }

/// Of a frame that is read back, all that an encoder writes.
void each_unit_word(const can::frame& frame, auto&& f) {
    f(frame.id);
    f(frame.length);
    f(load_le<std::uint64_t>(frame.data.data()));
}

/// The hand-written decoder's ordered sum over all fields, to judge encoders by.
tally can_read_back(unit_span<can::format> frames);

/// The traffic of two masters and their nodes on one bus, as one would record it.
stream<can::format> can_session(std::size_t bytes);

void add_can(std::vector<entry>& all, const scale& sizes);
void add_can_encode(std::vector<entry>& all, const scale& sizes);

}  // namespace trama::bench
