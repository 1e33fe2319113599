#pragma once
#include "tasks.hpp"
#include "traffic.hpp"
#include "trama/daisy/format.hpp"

namespace trama::bench {

template <>
struct traits<daisy::format> {
    using chosen = daisy::dc_motor::get_dc_speed_reply;
    static constexpr auto first = &chosen::direction;
    static constexpr auto second = &chosen::speed;
    static constexpr std::size_t chunks[] = {0, 65536, 1460, 64, 7, 1};
    static constexpr const char* clean_name = "trama, clean random mix";

    [[gnu::always_inline]] static void each_envelope_word(const daisy::envelope& e, auto&& f) {
        f(e.destination.octet);
        f(e.source.octet);
    }
    /// The bare LEN walk, which only a clean stream allows.
    static void add_limits(race& r, const shared_stream<daisy::format>& s, task t, bool clean);
    /// The library, as it is timed.
    static std::array<library_task<daisy::format>, std::size(all_tasks)> library();
    static library_task<daisy::format> typed_ahead();
    /// The typical code and the good one.
    static std::span<const by_hand_code<daisy::format>> by_hand();
    static void damage(std::uint8_t& b, dice& d) { b = static_cast<std::uint8_t>(b ^ 1U << d.below(8)); }
    /// Main controller to a board, or back.
    template <class M>
    static daisy::envelope addresses(dice& d) {
        const auto group = daisy::family_of(M::key) == daisy::family::common ? 1 + d.below(6) : static_cast<std::uint64_t>(daisy::family_of(M::key));
        const daisy::address board = daisy::board(static_cast<unsigned>(group), static_cast<unsigned>(d.below(15)));
        const bool response = (daisy::command_of(M::key) & daisy::response_bit) != 0;
        return response ? daisy::envelope{{0}, board} : daisy::envelope{board, {0}};
    }
};

/// The hand-written decoder's ordered sum over all fields, to judge encoders by.
tally daisy_read_back(unit_span<daisy::format> packets);

/// The requests that a controller sends over and over, with their answers: 26 packets.
void append_poll_cycle(stream<daisy::format>& s, dice& d);

void add_daisy(std::vector<entry>& all, const scale& sizes);
void add_daisy_encode(std::vector<entry>& all, const scale& sizes);

}  // namespace trama::bench
