#pragma once
#include "tasks.hpp"
#include "traffic.hpp"
#include "trama/daisy/format.hpp"

namespace trama::bench {

template <>
struct traits<daisy::format> {
    [[gnu::always_inline]] static std::uint64_t word_of_envelope(const daisy::packet& p) {
        const auto e = p.envelope();
        return e.destination.octet + 3U * e.source.octet;
    }
    [[gnu::always_inline]] static std::uint64_t two_fields(const daisy::packet& p) {
        using message = daisy::dc_motor::get_dc_speed_reply;
        const auto v = view_as<message>(p);
        if (!v) return 0;
        return static_cast<std::uint64_t>(*v->get<&message::direction>()) + static_cast<std::uint64_t>(std::int64_t{*v->get<&message::speed>()});
    }
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

namespace daisy_code {
using bytes_in = unit_span<daisy::format>;

tally walk(bytes_in in);  ///< The bare LEN walk: length to length, nothing else.
tally framing_machine(bytes_in in);
tally framing_pointers(bytes_in in);
tally typed_machine(bytes_in in);
tally typed_pointers(bytes_in in);
}  // namespace daisy_code

/// The requests that a controller sends over and over, with their answers: 26 packets.
void append_poll_cycle(stream<daisy::format>& s, dice& d);

void add_daisy(std::vector<entry>& all, const scale& sizes);
void add_daisy_encode(std::vector<entry>& all, const scale& sizes);

}  // namespace trama::bench
