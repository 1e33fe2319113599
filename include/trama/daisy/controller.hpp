#pragma once

#include "trama/daisy/controller_event.hpp"

namespace trama::daisy {

/// The main controller of a ring: asks, matches replies, asks again, keeps the list of boards, acknowledges alarms.
///
/// A packet from a source that is not on the ring would go round for ever. All packets pass by the controller, and of
/// those between boards it passes on only such whose source is in its list, each at most once within
/// `timing::orphan` (0: the same as `timeout`); what its memory cannot hold it does not pass on either. Boards exchange
/// nothing but `error`s, which time-outs make up for. So no packet passes the controller twice.
template <std::size_t InFlight = 8, std::size_t Boards = 16>
class controller {
public:
    static constexpr std::size_t max_output = 2 * max_packet;  ///< A reply, and a broadcast passed on.

    constexpr explicit controller(const timing& t = {}, address self = board(0, 0)) noexcept
        : self_(self), receiver_(t.idle), requests_(t), passed_(t.orphan != 0 ? t.orphan : t.timeout), alarms_(t.timeout * t.attempts) {}

    /// Sends `m` to a board or, by id 15, to a group or everyone: the bytes in `out`. `buffer_too_small` also when there
    /// is no place for it yet: all `InFlight` places are taken by requests that wait or settle, to whatever board, or one
    /// of them has the same command and a board in common with `to`. It is sent at most `attempts` times in all, 0: as
    /// `timing` says; 1 for what must not be carried out twice.
    template <request_message M>
    constexpr result<std::size_t> request(address to, const M& m, std::uint64_t now, std::span<std::uint8_t> out, unsigned attempts = 0) noexcept {
        return send(to, m, now, out, attempts, 0);
    }
    /// Calls everyone: each board that answers joins the list. `complete` when the call has gone round, everyone in the list has answered and
    /// the list holds at least `expected` boards; until then it is repeated. Fails as `request` does, and with
    /// `buffer_too_small` when `expected` is more than `Boards`. [daisy §3.1]
    constexpr result<std::size_t> initialise(std::uint64_t now, std::span<std::uint8_t> out, std::size_t expected = 0) noexcept {
        if (expected > Boards) return errc::buffer_too_small;
        return send(everyone, common::init{}, now, out, 0, static_cast<std::uint8_t>(expected));
    }

    /// Takes bytes from the front of `in`, deals with at most one packet and writes what is to be sent to `out`.
    constexpr controller_event next(std::span<const std::uint8_t>& in, std::uint64_t now, std::span<std::uint8_t> out) noexcept {
        controller_event e{};
        if (out.size() < max_output) {
            e.news = controller_news::no_room;
            return e;
        }
        packet_writer writer(out);
        const event got = receiver_.next(in, now, line_);
        e.packet = got.packet;
        e.peer = got.packet.envelope().source;
        if (got.code == errc::ok || got.code == errc::unknown_message) take(got.packet, now, writer, e);
        else if (got.code != errc::need_more) complain(got, writer, e);
        else repeat(now, writer, e);
        e.written = writer.size();
        line_.sent(writer.size(), writer.packets());
        return e;
    }

    constexpr const board_list<Boards>& boards() const noexcept { return boards_; }
    /// Forgets the boards, as before a new `initialise` on a ring that has changed, who has answered what is under way, and that it has come home.
    constexpr void forget_boards() noexcept {
        boards_.clear();
        requests_.forget_answers();
    }
    /// Requests that wait for a reply.
    constexpr std::size_t in_flight() const noexcept { return requests_.waiting(); }
    /// Of the line as a whole; each board has its own in the list.
    constexpr const link_quality& quality() const noexcept { return line_; }

private:
    template <class M>
    constexpr result<std::size_t> send(address to, const M& m, std::uint64_t now, std::span<std::uint8_t> out, unsigned attempts, std::uint8_t expected) noexcept {
        static_assert(min_packet + M::layout.max_size <= max_request);
        request_in_flight* place = requests_.place_for(to, command_of(M::key), now);
        if (place == nullptr) return errc::buffer_too_small;
        const auto size = format::encode({to, self_}, m, out);
        if (size) {
            requests_.add(*place, out.first(*size), now, attempts);
            place->expected = expected;
            line_.sent(*size);
            count_sent(to, *size);
        }
        return size;
    }
    constexpr void take(const packet& p, std::uint64_t now, packet_writer& out, controller_event& e) noexcept {
        const route way = route_of(p.envelope(), self_);
        if (board_info* b = boards_.find(e.peer)) b->quality.received(p.bytes().size(), now);
        e.news = controller_news::removed;
        if (way == route::remove) return came_back(p, now, e);
        const bool goes_on = way != route::consume;
        // The memory for packets passed on is asked last: it notes what it is asked about.
        if (goes_on && boards_.find(e.peer) == nullptr) return;
        if (goes_on && passed_.judge(p.bytes(), now) != orphan_filter<passing>::verdict::fresh) return;
        if (way != route::pass_on) consume(p, now, out, e);
        else e.news = controller_news::passed_on;
        if (goes_on) out.copy(p.bytes());
    }
    constexpr void consume(const packet& p, std::uint64_t now, packet_writer& out, controller_event& e) noexcept {
        e.news = controller_news::told;
        if (p.response()) answered(p, now, e);
        else if (p.key() == common::error::key) troubled(p, now, out, e);
        else asked(p, now, out, e);
    }

    /// A reply.
    constexpr void answered(const packet& p, std::uint64_t now, controller_event& e) noexcept {
        request_in_flight* r = requests_.find(e.peer, p.command());
        const std::size_t before = boards_.size();
        list(p, now);
        if (r == nullptr) return;
        about(*r, e);
        e.peer = p.envelope().source;
        if (!note_answer(*r, e.peer)) return;
        e.news = boards_.size() != before ? controller_news::board : controller_news::reply;
        if (board_info* b = boards_.find(e.peer)) b->quality.round_trip.add(elapsed(r->latest, now));
        line_.round_trip.add(elapsed(r->latest, now));
        if (!r->destination().broadcast()) requests_.finish(*r, now);
    }
    /// Replies to init and reset make the list of boards.
    constexpr void list(const packet& p, std::uint64_t now) noexcept {
        if (p.key() != common::init_reply::key && p.key() != common::reset_reply::key) return;
        const address from = p.envelope().source;
        if (family_of(from.group()) == family::none) return;
        board_info* b = boards_.find(from);
        if (b == nullptr) {
            b = boards_.add(from);
            if (b != nullptr) b->quality.received(p.bytes().size(), now);
        }
        if (b != nullptr) b->describe(p.body());
    }
    /// False when the board has answered this broadcast before.
    constexpr bool note_answer(request_in_flight& r, address peer) noexcept {
        const std::uint64_t bit = r.destination().broadcast() ? boards_.bit_of(peer) : 0;
        if ((r.answered & bit) != 0) return false;
        r.answered |= bit;
        return true;
    }
    /// Whether a broadcast has gone round, and nobody is missing.
    constexpr bool is_complete(const request_in_flight& r) const noexcept {
        return r.home && (boards_.reached_by(r.destination()) & ~r.answered) == 0 && boards_.size() >= r.expected;
    }

    // controller_parts.hpp holds these.
    constexpr void troubled(const packet& p, std::uint64_t now, packet_writer& out, controller_event& e) noexcept;
    constexpr void asked(const packet& p, std::uint64_t now, packet_writer& out, controller_event& e) noexcept;
    constexpr void came_back(const packet& p, std::uint64_t now, controller_event& e) noexcept;
    constexpr void complain(const event& got, packet_writer& out, controller_event& e) noexcept;

    /// A broadcast whose last reply came after it was home, or a request without a reply.
    constexpr void repeat(std::uint64_t now, packet_writer& out, controller_event& e) noexcept {
        request_in_flight* r = requests_.waiting_one([this](const request_in_flight& one) { return is_complete(one); });
        if (r != nullptr) return complete(*r, now, e);
        r = requests_.overdue(now);
        if (r == nullptr) return;
        board_info* b = boards_.find(r->destination());
        ++line_.timeouts;
        if (b != nullptr) ++b->quality.timeouts;
        if (requests_.may_repeat(*r)) return send_again(*r, now, out, e);
        about(*r, e);
        e.news = controller_news::failed;
        ++line_.failures;
        if (b != nullptr) ++b->quality.failures;
        requests_.give_up(*r, now);
    }
    constexpr void complete(request_in_flight& r, std::uint64_t now, controller_event& e) noexcept {
        about(r, e);
        e.news = controller_news::complete;
        requests_.finish(r, now);
    }
    constexpr void send_again(request_in_flight& r, std::uint64_t now, packet_writer& out, controller_event& e) noexcept {
        out.copy(r.packet());
        requests_.repeated(r, now);
        about(r, e);
        e.news = controller_news::sent_again;
        ++line_.retries;
        if (board_info* b = boards_.find(r.destination())) ++b->quality.retries;
        count_sent(r.destination(), r.size);
    }
    static constexpr void about(const request_in_flight& r, controller_event& e) noexcept {
        e.peer = r.destination();
        e.command = r.command();
        e.attempt = r.attempts;
    }
    /// A packet to one board, if it is in the list; the line counts by itself.
    constexpr void count_sent(address to, std::size_t size) noexcept {
        board_info* b = boards_.find(to);
        if (b != nullptr && size != 0) b->quality.sent(size);
    }

    static constexpr std::size_t passing = 16;
    address self_;
    receiver receiver_;
    request_table<InFlight> requests_;
    orphan_filter<passing> passed_;
    alarm_memory<std::max<std::size_t>(2 * Boards, 16)> alarms_;  // no family has more than two alarms
    board_list<Boards> boards_{};
    link_quality line_{};
};

}  // namespace trama::daisy

#include "trama/daisy/controller_parts.hpp"
