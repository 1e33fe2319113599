#pragma once

#include "trama/daisy/node_event.hpp"

namespace trama::daisy {

/// A board on the ring: carries out what is for it, answers, passes on the rest. [daisy §1, §3]
///
/// A broadcast is answered first and passed on then, so that on a ring without damage all replies reach the main
/// controller before its own broadcast comes back to it.
///
/// Packets that nobody takes off: the controller removes them (see there). On a ring without one, or for a second
/// guard, `timing::orphan` makes the node remove any packet that it has passed on within that time. It has to be longer
/// than a round and shorter than the time after which anybody sends the same bytes anew, time-outs included. What is
/// sent again at once after an `error` 0 is removed as well; the time-out makes up for it.
template <std::size_t Alarms = 2, std::size_t Description = 64>
class node {
public:
    static_assert(Description <= max_packet - min_packet, "no reply could hold it");

    static constexpr std::size_t max_output = 2 * max_packet;  ///< A reply, and a broadcast passed on.

    /// `self` is the board's address, id 0..14. `description` answers `init` and `reset`; what is longer than
    /// `Description`, at most 251, is cut.
    constexpr node(address self, std::string_view description, const timing& t = {}) noexcept
        : self_(self), timing_(t), receiver_(t.idle), alarms_(t), passed_(t.orphan) {
        for (; text_size_ != description.size() && text_size_ != Description; ++text_size_) text_[text_size_] = static_cast<std::uint8_t>(description[text_size_]);
    }

    /// Sends an alarm, or any request, to `to`: the bytes in `out`. `buffer_too_small` also when there
    /// is no place for it yet, as in `controller::request`. It is repeated until its reply comes or the attempts are used up;
    /// refusals, and its coming home, do not end it sooner.
    template <request_message M>
    constexpr result<std::size_t> send(address to, const M& m, std::uint64_t now, std::span<std::uint8_t> out) noexcept {
        static_assert(min_packet + M::layout.max_size <= max_request);
        request_in_flight* place = alarms_.place_for(to, command_of(M::key), now);
        if (place == nullptr) return errc::buffer_too_small;
        const auto size = format::encode({to, self_}, m, out);
        if (size) {
            alarms_.add(*place, out.first(*size), now, 0);
            line_.sent(*size);
        }
        return size;
    }

    /// Takes bytes from the front of `in`, deals with at most one packet and writes what is to be sent to `out`.
    ///
    /// `handler(const M& request, reply_of<M>& reply)` carries a request out and returns an `answer`; a command for which
    /// there is no such overload is unknown. `init`, `reset` and `ping` need none. Requests with values out of range
    /// never reach it.
    template <class Handler>
    constexpr node_event next(std::span<const std::uint8_t>& in, std::uint64_t now, std::span<std::uint8_t> out, Handler&& handler) noexcept {
        node_event e{};
        if (out.size() < max_output) {
            e.news = node_news::no_room;
            return e;
        }
        packet_writer writer(out);
        const event got = receiver_.next(in, now, line_);
        e.packet = got.packet;
        if (got.code == errc::ok || got.code == errc::unknown_message) take(got.packet, now, writer, handler, e);
        else if (got.code != errc::need_more) complain(got, writer, e);
        else repeat(now, writer, e);
        e.written = writer.size();
        line_.sent(writer.size(), writer.packets());
        return e;
    }

    constexpr address self() const noexcept { return self_; }
    /// Alarms that wait for their reply.
    constexpr std::size_t in_flight() const noexcept { return alarms_.waiting(); }
    constexpr const link_quality& quality() const noexcept { return line_; }

private:
    constexpr void take(const packet& p, std::uint64_t now, packet_writer& out, auto& handler, node_event& e) noexcept {
        const route way = route_of(p.envelope(), self_);
        const bool mine = way == route::consume || way == route::consume_and_pass_on;
        e.news = node_news::removed;
        if (way == route::remove) return;
        const bool goes_on = way != route::consume;
        if (goes_on && timing_.orphan != 0 && passed_.judge(p.bytes(), now) == orphan_filter<orphans>::verdict::repeated) return;
        if (mine) consume(p, now, out, handler, e);
        if (!mine) e.news = node_news::passed_on;
        if (goes_on) out.copy(p.bytes());
    }
    constexpr void consume(const packet& p, std::uint64_t now, packet_writer& out, auto& handler, node_event& e) noexcept {
        e.news = node_news::told;
        if (p.response()) {
            request_in_flight* alarm = alarms_.find(p.envelope().source, p.command());
            if (alarm == nullptr) return;
            e.news = node_news::confirmed;
            line_.round_trip.add(elapsed(alarm->latest, now));
            alarms_.finish(*alarm, now);
        } else if (p.key() == common::error::key) {
            resend(p, now, out, e);
        } else {
            execute(p, out, handler, e);
        }
    }

    /// A request for this board.
    constexpr void execute(const packet& p, packet_writer& out, auto& handler, node_event& e) noexcept {
        e.verdict = answer::unknown_command;
        const envelope back{p.envelope().source, self_};
        std::span<const std::uint8_t> sent{};
        messages::at(p.index(), [&]<class M>() {
            if constexpr (request_message<M>) {
                const result<M> m = decode<M>(p);
                reply_of<M> reply{};
                e.verdict = !m ? answer::failed : !is_valid(*m) ? answer::out_of_range : run(*m, reply, handler);
                if (e.verdict != answer::done) return;
                sent = out.put(back, reply);
                if (sent.empty()) e.verdict = answer::failed;
            }
        });
        e.news = e.verdict == answer::done ? node_news::executed : node_news::refused;
        if (e.verdict != answer::done) sent = out.put(back, common::error{static_cast<std::uint8_t>(e.verdict), {}, 0});
        remember(sent);
    }
    template <class M>
    constexpr answer run(const M& m, reply_of<M>& reply, auto& handler) noexcept {
        if constexpr (requires { reply.description; }) reply.description = std::span<const std::uint8_t>(text_.data(), text_size_);
        if constexpr (requires { handler(m, reply); }) return handler(m, reply);
        else return family_of(M::key) == family::common ? answer::done : answer::unknown_command;
    }

    /// The latest reply is kept for the case that somebody reports it as damaged.
    constexpr void remember(std::span<const std::uint8_t> sent) noexcept {
        copy_bytes(reply_.data(), sent.data(), sent.size());
        reply_size_ = sent.size();
        reply_attempts_ = 1;
    }
    /// An `error` came: about a bad CRC, the packet is sent again if it is known. [daisy §3.4]
    constexpr void resend(const packet& p, std::uint64_t now, packet_writer& out, node_event& e) noexcept {
        const auto told = decode<common::error>(p);
        if (!told || told->code != bad_crc_code) return;
        ++line_.rejections;
        const std::span<const std::uint8_t> reply(reply_.data(), reply_size_), rejected = told->rejected.bytes();
        request_in_flight* alarm = alarms_.nearest(rejected);
        // If both are as close, the reply: an alarm is repeated anyway, but without a reply the request is carried out twice.
        const bool replied = resembles(reply, rejected) && (alarm == nullptr || differing(reply, rejected) <= differing(alarm->packet(), rejected));
        if (replied ? reply_attempts_ >= timing_.attempts : alarm == nullptr || !alarms_.may_repeat(*alarm)) return;
        out.copy(replied ? reply : alarm->packet());
        if (replied) ++reply_attempts_;
        else alarms_.repeated(*alarm, now);
        ++line_.retries;
        e.news = node_news::sent_again;
    }
    /// An alarm without a reply.
    constexpr void repeat(std::uint64_t now, packet_writer& out, node_event& e) noexcept {
        request_in_flight* late = alarms_.overdue(now);
        if (late == nullptr) return;
        ++line_.timeouts;
        const bool again = alarms_.may_repeat(*late);
        e.news = again ? node_news::sent_again : node_news::lost;
        ++(again ? line_.retries : line_.failures);
        if (again) out.copy(late->packet());
        if (again) alarms_.repeated(*late, now);
        else alarms_.give_up(*late, now);
    }
    /// A packet came damaged. [daisy §3.4]
    constexpr void complain(const event& got, packet_writer& out, node_event& e) noexcept {
        e.news = node_news::fault;
        e.code = got.code;
        e.skipped = got.length;
        if (got.code != errc::bad_checksum || !deserves_error(got.rejected, self_)) return;
        out.put({{got.rejected[2]}, self_}, common::error{bad_crc_code, got.rejected, got.expected});
    }

    static constexpr std::size_t orphans = 16;
    address self_;
    timing timing_;
    receiver receiver_;
    request_table<Alarms> alarms_;
    orphan_filter<orphans> passed_;
    link_quality line_{};
    std::size_t text_size_ = 0;
    std::array<std::uint8_t, Description> text_{};
    std::size_t reply_size_ = 0;
    unsigned reply_attempts_ = 0;
    std::array<std::uint8_t, max_packet> reply_{};
};

}  // namespace trama::daisy
