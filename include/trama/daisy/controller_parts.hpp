#pragma once
// The rarer parts of daisy/controller.hpp, which includes this file.
#include "trama/daisy/controller.hpp"

namespace trama::daisy {

/// An error came. [daisy §3.4]
template <std::size_t InFlight, std::size_t Boards>
constexpr void controller<InFlight, Boards>::troubled(const packet& p, std::uint64_t now, packet_writer& out, controller_event& e) noexcept {
    const auto told = decode<common::error>(p);
    if (!told) return;
    if (told->code == bad_crc_code) {
        ++line_.rejections;
        if (board_info* b = boards_.find(e.peer)) ++b->quality.rejections;
        request_in_flight* r = requests_.nearest(told->rejected.bytes());
        if (r != nullptr && requests_.may_repeat(*r)) send_again(*r, now, out, e);
        return;
    }
    const std::uint64_t bit = boards_.bit_of(e.peer);
    if (requests_.refused_before(e.peer, bit, now)) return;
    request_in_flight* r = requests_.oldest_to(e.peer, bit);
    if (r == nullptr || !note_answer(*r, e.peer)) return;
    const bool wide = r->destination().broadcast();
    r->refused |= wide ? bit : 1;
    about(*r, e);
    e.peer = p.envelope().source;
    e.news = controller_news::refused;
    if (!wide) requests_.give_up(*r, now);  // another request may be what was refused
}

/// A request for the controller.
template <std::size_t InFlight, std::size_t Boards>
constexpr void controller<InFlight, Boards>::asked(const packet& p, std::uint64_t now, packet_writer& out, controller_event& e) noexcept {
    e.news = controller_news::refusal;
    std::span<const std::uint8_t> sent{};
    messages::at(p.index(), [&]<class M>() {
        if constexpr (alarm_message<M> || std::is_same_v<M, common::ping>) {
            sent = out.put({e.peer, self_}, reply_of<M>{});
            if constexpr (alarm_message<M>) e.news = controller_news::alarm;
            else e.news = controller_news::told;
        }
    });
    if (sent.empty()) sent = out.put({e.peer, self_}, common::error{unknown_command_code, {}, 0});
    count_sent(e.peer, sent.size());
    if (e.news == controller_news::alarm) e.again = alarms_.repeated(p, now);
}

/// A packet of the controller's own has gone round.
template <std::size_t InFlight, std::size_t Boards>
constexpr void controller<InFlight, Boards>::came_back(const packet& p, std::uint64_t now, controller_event& e) noexcept {
    request_in_flight* r = p.envelope().source == self_ ? requests_.same_as(p.bytes()) : nullptr;
    if (r == nullptr) return;
    if (r->destination().broadcast()) {
        r->home = true;
        if (is_complete(*r)) complete(*r, now, e);
        return;  // or who is missing answers yet, or the time-out repeats it
    }
    about(*r, e);
    e.news = controller_news::absent;
    ++line_.failures;
    if (board_info* b = boards_.find(r->destination())) ++b->quality.failures;
    requests_.finish(*r, now);
}

/// A packet came damaged. [daisy §3.4]
template <std::size_t InFlight, std::size_t Boards>
constexpr void controller<InFlight, Boards>::complain(const event& got, packet_writer& out, controller_event& e) noexcept {
    e.news = controller_news::fault;
    e.code = got.code;
    e.skipped = got.length;
    if (got.code != errc::bad_checksum || !deserves_error(got.rejected, self_)) return;
    const address to{got.rejected[2]};
    count_sent(to, out.put({to, self_}, common::error{bad_crc_code, got.rejected, got.expected}).size());
}

}  // namespace trama::daisy
