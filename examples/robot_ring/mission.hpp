#pragma once
// The main controller's work: find the boards, set and read back, listen to alarms.

#include <optional>
#include <set>

#include "boards.hpp"
#include "ring.hpp"
#include "trama/core/print.hpp"
#include "trama/daisy/controller.hpp"

namespace robot {

class mission {
public:
    mission(ends& line, const daisy::timing& t, std::uint64_t deadline) : line_(line), controller_(t), deadline_(deadline), began_(now()) {}

    bool over() const { return stopped != 0 || (deadline_ != 0 && now() >= deadline_); }

    /// Every board is in the list.
    bool find_boards(std::size_t expected) {
        bool complete = false;
        while (!complete && !over()) {
            octets out(daisy::max_packet);
            const auto size = controller_.initialise(now(), out, expected);
            if (!size) { work([](const auto&) {}); continue; }  // the call before it is settling
            line_.send(std::span(out).first(*size));
            bool failed = false;
            while (!complete && !failed && !over())
                work([&](const daisy::controller_event& e) {
                    complete = complete || e.news == daisy::controller_news::complete;
                    failed = failed || e.news == daisy::controller_news::failed;
                });
        }
        for (const daisy::board_info& b : controller_.boards())
            say("board %u:%u is there: %.*s", b.where.group(), b.where.id(), static_cast<int>(b.description().size()), reinterpret_cast<const char*>(b.description().data()));
        return complete;
    }

    /// Asks until a reply comes. A board that cannot be found or does not know the command is asked again: the request
    /// itself may have been damaged in a way that the XOR does not show.
    template <class M>
    std::optional<daisy::reply_of<M>> ask(daisy::address to, const M& m) {
        std::optional<daisy::reply_of<M>> reply;
        while (!reply && !over()) {
            octets out(daisy::max_packet);
            const auto size = controller_.request(to, m, now(), out);
            if (!size) { work([](const auto&) {}); continue; }  // the same request is settling
            line_.send(std::span(out).first(*size));
            for (bool settled = false; !settled && !over();)
                work([&](const daisy::controller_event& e) {
                    if (e.peer != to || e.command != daisy::command_of(M::key)) return;
                    if (e.news == daisy::controller_news::reply)
                        if (const auto got = trama::decode<daisy::reply_of<M>>(e.packet)) reply = *got;
                    using enum daisy::controller_news;
                    settled = settled || e.news == daisy::controller_news::reply || e.news == refused || e.news == absent || e.news == failed;
                });
        }
        return reply;
    }
    /// Asks until two replies in a row are the same: one of them may be damaged in a way that the XOR does not show.
    template <class M>
    std::optional<daisy::reply_of<M>> ask_surely(daisy::address to, const M& m) {
        auto before = ask(to, m);
        while (!over()) {
            const auto again = ask(to, m);
            if (again && again == before) return again;
            before = again;
        }
        return std::nullopt;
    }
    /// Sets something until reading it back gives `wanted`. Counts what was not right at once.
    template <class Set, class Get, class Wanted>
    bool set_surely(daisy::address to, const Set& set, const Get& get, const Wanted& wanted) {
        for (;; ++set_again_) {
            if (!ask(to, set)) return false;
            const auto got = ask_surely(to, get);
            if (!got) return false;
            if (*got == wanted) return true;
        }
    }

    /// Lets time go by.
    void idle(std::uint64_t milliseconds) {
        for (const std::uint64_t end = now() + milliseconds; now() < end && !over();) work([](const auto&) {});
    }
    template <class... A>
    void say(const char* format, A... values) const {
        std::printf("%7.3f s  ", static_cast<double>(now() - began_) / 1000);
        if constexpr (sizeof...(A) == 0) std::fputs(format, stdout);
        else std::printf(format, values...);
        std::printf("\n");
        flush_output();
    }
    const daisy::controller<>& controller() const { return controller_; }
    const std::set<unsigned>& alarms() const { return alarms_; }
    int alarms_twice() const { return alarms_twice_; }
    int set_again() const { return set_again_; }

private:
    /// One turn: what has come goes to the controller, what it says goes out, its events to `heard`.
    template <class F>
    void work(F&& heard) {
        const octets in = line_.wait(5);
        octets out(daisy::controller<>::max_output);
        for (std::span<const std::uint8_t> rest(in);;) {
            const auto e = controller_.next(rest, now(), out);
            if (e.news == daisy::controller_news::need_more) return;
            line_.send(std::span(out).first(e.written));
            if (e.news == daisy::controller_news::alarm) note(e);
            heard(e);
        }
    }
    void note(const daisy::controller_event& e) {
        const auto m = trama::decode<daisy::battery_controller::battery_empty_alarm>(e.packet);
        if (!m || e.again) return;
        if (!alarms_.insert(m->value).second) ++alarms_twice_;
        say("alarm of %u:%u: battery at %u", e.peer.group(), e.peer.id(), unsigned{m->value});
    }

    ends& line_;
    daisy::controller<> controller_;
    std::uint64_t deadline_, began_;
    std::set<unsigned> alarms_;
    int alarms_twice_ = 0;
    int set_again_ = 0;
};

}  // namespace robot
