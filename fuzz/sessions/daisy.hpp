#pragma once
// A ring of a controller and three boards, and lines between them that a script damages.
#include <algorithm>
#include <map>
#include <set>

#include "sessions/daisy_board.hpp"
#include "trama/daisy/controller.hpp"

namespace trama::fuzz {

class daisy_session {
    using F = daisy::format;
    using board = daisy::node<2, 32>;
    static constexpr std::size_t boards = 3, in_flight = 4;
    static constexpr daisy::timing patience{40, 3, 12, 0};
    static constexpr std::array<daisy::address, boards> addresses{daisy::board(1, 0), daisy::board(1, 1), daisy::board(2, 0)};
    static constexpr std::array<std::string_view, boards> descriptions{"first", "second", "third"};

public:
    /// What is sent is printed where `print` says so; what becomes of it on the line is not in it.
    daisy_session(std::span<const std::uint8_t> script, bool print) : d_(hash_of(script), script), print_(print) {}
    void run() {
        play(d_, [&] { step(); });
        settle();
    }

private:
    /// What is known of a request; a call's answers.
    struct call_under_way {
        std::size_t expected = 0;
        unsigned allowed = 0;  ///< Attempts.
        octets sent;
        bool home = false;
        std::set<std::uint8_t> answered;  ///< By boards that were in the list then.
    };

    void step() {
        const std::size_t what = d_.below(16);
        if (what < 3) request();
        else if (what == 3) call(d_.below(boards + 1));
        else if (what == 4) alarm(d_.below(boards));
        else if (what == 5) pass_time(now_, d_.below(60), d_);
        else if (what < 9) damaged_ |= lines_[d_.below(lines_.size())].damage(d_);
        else if (what == 9) forget_boards();
        else deliver(1 + d_.below(12));
        newest_ = std::max(newest_, now_);
    }

    void request() {
        F::messages::at(d_.below(F::messages::count), [&]<class M>() {
            if constexpr (daisy::request_message<M>) {
                arena memory;
                M m = random_message<M>(d_, memory);
                if (d_.one_in(8)) change_one_value(m, d_, memory);
                const auto to = destination(daisy::family_of(M::key));
                const auto attempts = static_cast<unsigned>(d_.below(3));
                ask(to, m, attempts);
            }
        });
    }
    /// A board that is there, a group, everyone, or nobody.
    daisy::address destination(daisy::family family) {
        const auto group = family == daisy::family::common ? static_cast<unsigned>(1 + d_.below(3)) : static_cast<unsigned>(family);
        const std::size_t which = d_.below(8);
        return which == 0 ? daisy::everyone : daisy::board(group, which == 1 ? 15U : which == 2 ? 9U : static_cast<unsigned>(which % 2));
    }
    template <class M>
    bool ask(daisy::address to, const M& m, unsigned attempts) {
        exact<std::uint8_t> out(daisy::max_packet);
        const std::size_t waiting = controller_.in_flight();
        const auto size = controller_.request(to, m, now_, out.all(), attempts);
        require(controller_.in_flight() == waiting + (size ? 1 : 0), "a request that is sent waits, no other does");
        if (size) {
            require(is_valid(m), "what is sent is valid");
            begun({to.octet, daisy::command_of(M::key)}, 0, attempts != 0 ? attempts : patience.attempts, out.all().first(*size));
        }
        return bool(size);
    }
    bool call(std::size_t expected) {
        exact<std::uint8_t> out(daisy::max_packet);
        const auto size = controller_.initialise(now_, out.all(), expected);
        if (!size) return false;
        begun({daisy::everyone.octet, daisy::command_of(daisy::common::init::key)}, expected, patience.attempts, out.all().first(*size));
        return true;
    }
    void begun(std::pair<std::uint8_t, std::uint8_t> request, std::size_t expected, unsigned allowed, std::span<const std::uint8_t> bytes) {
        require(open_.insert({request, {expected, allowed, {bytes.begin(), bytes.end()}, false, {}}}).second, "no two requests that one reply could answer are in flight");
        put(0, bytes);
    }
    bool alarm(std::size_t from) {
        exact<std::uint8_t> out(daisy::max_packet);
        const auto send = [&](const auto& m) { return boards_[from].send(daisy::board(0, 0), m, now_, out.all()); };
        arena memory;
        const auto size = from == 2 ? send(random_message<daisy::servo_motor::switch_alarm>(d_, memory)) : send(random_message<daisy::dc_motor::motor_stress_alarm>(d_, memory));
        if (size) put(from + 1, out.all().first(*size));
        return bool(size);
    }

    /// Whole packets only leave a member.
    void put(std::size_t line, std::span<const std::uint8_t> bytes) {
        for (auto rest = bytes; !rest.empty();) {
            const std::size_t size = std::size_t{rest[0]} + 1;
            require(size >= daisy::min_packet && size <= rest.size(), "a member sends whole packets");
            require(daisy::checksum(rest.first(size)) == 0, "a member sends intact packets");
            rest = rest.subspan(size);
            sent_ += line == 0 ? 1U : 0U;
        }
        sent_bytes_ += line == 0 ? bytes.size() : 0;
        lines_[line].send(bytes);
        if (print_) print_sent<F>(bytes);
    }
    /// Every line delivers up to `n` bytes; a byte takes one unit of time.
    void deliver(std::size_t n) {
        std::array<octets, boards + 1> arrived;
        ++now_;
        for (std::size_t i = 0; i != arrived.size(); ++i) {
            // A pause inside a packet is damage, too: its end is lost.
            damaged_ |= now_ > delivered_ + patience.idle && !lines_[i].under_way.empty();
            arrived[i] = lines_[i].take(n);
        }
        delivered_ = now_;
        exact<std::uint8_t> out(board::max_output);
        for (std::size_t i = 0; i != boards; ++i) {
            const exact<std::uint8_t> copy{std::span<const std::uint8_t>(arrived[i])};
            std::span<const std::uint8_t> in = copy.all();
            until_done([&] {
                const auto e = boards_[i].next(in, now_, out.all(), obliging{addresses[i], &d_, &given_, may_refuse_});
                put(i + 1, std::span<const std::uint8_t>(out.all()).first(e.written));
                confirmed_ += e.news == daisy::node_news::confirmed ? 1U : 0U;
                return e.news != daisy::node_news::need_more;
            }, 2 * (n + daisy::max_packet));
            require(in.empty(), "need_more means that the chunk is used up");
        }
        const exact<std::uint8_t> copy{std::span<const std::uint8_t>(arrived[boards])};
        std::span<const std::uint8_t> in = copy.all();
        require(controller_.next(in, now_, std::span(out.all()).first(board::max_output - 1)).news == daisy::controller_news::no_room && in.size() == arrived[boards].size(),
                "without room nothing is consumed");
        until_done([&] {
            const auto e = controller_.next(in, now_, out.all());
            put(0, std::span<const std::uint8_t>(out.all()).first(e.written));
            heard(e);
            return e.news != daisy::controller_news::need_more;
        }, 2 * (n + daisy::max_packet));
        require(in.empty(), "need_more means that the chunk is used up");
    }
    void heard(const daisy::controller_event& e) {
        using daisy::controller_news;
        switch (e.news) {
            case controller_news::reply: case controller_news::board: case controller_news::refused:
                if (const auto at = open_.find({e.peer.octet, e.command}); at != open_.end()) open_.erase(at);
                if (const auto& known = controller_.boards(); known.index_of_board(e.peer) != known.size())
                    for (auto& [request, o] : open_)
                        if (request.second == e.command && daisy::reaches({request.first}, e.peer)) o.answered.insert(e.peer.octet);
                ++replies_;
                round_trips_ += e.news == controller_news::refused ? 0U : 1U;
                if (!damaged_ && e.news == controller_news::reply) require(given_.holds(e.peer, e.packet), "a reply says what the board said");
                break;
            case controller_news::absent: case controller_news::complete: case controller_news::failed: {
                const auto at = open_.find({e.peer.octet, e.command});
                require(at != open_.end(), "a request ends once");
                if (e.peer.broadcast()) require((e.news == controller_news::complete) == nobody_is_missing(e, at->second), "a call is complete when it is home and everyone has answered");
                require(e.news != controller_news::failed || e.attempt == at->second.allowed, "a request fails after its last attempt");
                open_.erase(at);
                failures_ += e.news == controller_news::complete ? 0U : 1U;
                break;
            }
            case controller_news::removed:
                if (const auto at = open_.find({e.packet.envelope().destination.octet, e.packet.command()}); e.peer == daisy::board(0, 0) && at != open_.end())
                    at->second.home |= std::ranges::equal(at->second.sent, e.packet.bytes());
                break;
            case controller_news::sent_again: {
                const auto at = open_.find({e.peer.octet, e.command});
                require(at != open_.end() && e.attempt >= 2 && e.attempt <= at->second.allowed, "a request is sent as often as it may be");
                ++retries_;
                break;
            }
            case controller_news::alarm: ++alarms_; break;
            default: break;
        }
        const link_quality& q = controller_.quality();
        require(q.failures == failures_ && q.retries == retries_ && q.round_trip.count == round_trips_, "a controller counts how its requests end");
        require(controller_.in_flight() == open_.size(), "a controller knows how many requests wait");
    }
    bool nobody_is_missing(const daisy::controller_event& e, const call_under_way& o) const {
        const auto& known = controller_.boards();
        const bool everybody = std::all_of(known.begin(), known.end(), [&](const auto& b) { return !daisy::reaches(e.peer, b.where) || o.answered.contains(b.where.octet); });
        const bool home = o.home || std::ranges::equal(o.sent, e.packet.bytes());  // the latter: just now
        return home && everybody && known.size() >= o.expected;
    }
    void forget_boards() {
        controller_.forget_boards();
        for (auto& [request, o] : open_) {
            o.home = false;
            o.answered.clear();
        }
    }
    /// As `deliver`; where nothing moves, time goes faster, or it would take long until their patience ends.
    void wait() {
        bool still = true;
        for (const auto& l : lines_) still = still && l.under_way.empty();
        if (still) now_ = std::max(now_ + 5, newest_);  // no member lives in the time before the clock was set back
        deliver(64);
    }
    /// Good lines for as long as it takes: all comes to rest, then a new request is answered and a call finds every board, whatever came before.
    void settle() {
        const auto at_rest = [&] {
            bool quiet = open_.empty();
            for (const auto& b : boards_) quiet = quiet && b.in_flight() == 0;
            for (const auto& l : lines_) quiet = quiet && l.under_way.empty();
            return quiet;
        };
        for (int steps = 0, rests = 0; rests != 15; ++steps) {
            require(steps != 5000, "nothing goes round for ever, and no request waits for ever");
            wait();
            rests = at_rest() ? rests + 1 : 0;
        }
        const auto replies = replies_, failures = failures_;
        may_refuse_ = false;
        // Taken as soon as nothing settles that could get the same reply: where the clock was set back, that takes its time.
        const auto carry_out = [&](auto&& begin) {
            for (int steps = 0; !begin(); wait()) require(++steps != 6000, "a ring at rest takes a request");
            for (int steps = 0; !at_rest(); wait()) require(++steps != 1000, "a request on a ring at rest comes to an end");
        };
        carry_out([&] { return ask(addresses[1], daisy::common::ping{}, 0); });
        require(replies_ == replies + 1 && failures_ == failures, "on good lines a request is answered, whatever came before");
        const auto alarms = alarms_, confirmed = confirmed_;
        carry_out([&] { return alarm(0); });
        require(alarms_ == alarms + 1 && confirmed_ == confirmed + 1, "on good lines an alarm is told of once and confirmed");
        forget_boards();
        carry_out([&] { return call(boards); });
        require(controller_.boards().size() == boards && failures_ == failures, "on good lines a call finds every board, whatever came before");
        for (std::size_t i = 0; i != boards; ++i) {
            const auto words = controller_.boards()[i].description();
            require(controller_.boards()[i].where == addresses[i] && std::ranges::equal(words, descriptions[i]), "boards are listed as they are");
        }
        require(controller_.quality().packets_sent == sent_ && controller_.quality().bytes_sent == sent_bytes_, "a controller counts what it sends");
    }

    dice d_;
    bool print_;
    daisy::controller<in_flight, boards> controller_{patience};
    std::array<board, boards> boards_{board{addresses[0], descriptions[0], patience}, board{addresses[1], descriptions[1], patience}, board{addresses[2], descriptions[2], patience}};
    std::array<byte_line, boards + 1> lines_{};  ///< lines_[i] ends at board i, the last one at the controller.
    std::uint64_t now_ = 0, newest_ = 0;  ///< The latter: the latest time that there was.
    std::uint64_t delivered_ = 0;         ///< When something was delivered last.
    std::map<std::pair<std::uint8_t, std::uint8_t>, call_under_way> open_;  ///< What waits, by destination and command.
    replies_given given_;
    bool may_refuse_ = true;  ///< Boards may, for a reason of their own.
    bool damaged_ = false;    ///< Bytes did not arrive as they were sent.
    std::uint64_t replies_ = 0, round_trips_ = 0, failures_ = 0, retries_ = 0, alarms_ = 0, confirmed_ = 0;
    std::uint64_t sent_ = 0, sent_bytes_ = 0;  ///< By the controller.
};

}  // namespace trama::fuzz
