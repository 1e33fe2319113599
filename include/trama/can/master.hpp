#pragma once

#include "trama/can/master_event.hpp"

namespace trama::can {

/// A master: sends requests one at a time, waits for each reply with a time-out, asks again, and polls its nodes' sensors
/// every `timing::poll`, later if the round before is not over. [can §1..§5]
///
/// One request at a time, since requests and replies of all its nodes bear the same identifier: a request sent while a
/// node answers would come between the frames of the reply [D6, D7]. For the same reason the next request waits when one
/// was sent more than once: until each attempt has been answered, or until one time-out has gone by without a reply.
///
/// `Nodes` are those it can poll, `Requests` those that can wait: a round of polls begins when there is room for all of it and
/// nothing of the round before waits any more, so that dead nodes do not keep everything else out.
template <std::size_t Nodes = 8, std::size_t Requests = 16>
    requires(Nodes <= Requests)
class master {
public:
    /// `id` is the master's identifier: `central_master`, `master_1`, `master_2`. A master whose `confirms_clock` is set
    /// echoes the central master's `set_clock` to everyone; let one only do so, echoes of several would mix.
    constexpr explicit master(std::uint32_t id, const timing& t = {}, bool confirms_clock = false) noexcept
        : id_(id), timing_(t), confirms_clock_(confirms_clock), reassembler_({id, central_master}, t.partial), calendar_(t.second) {}

    /// Polls `node` every `timing::poll` from the next round on. False when there are `Nodes` others already.
    constexpr bool poll(std::uint8_t node) noexcept { return nodes_.add(node); }
    /// Queues `m` under the next message_id, which it returns. `buffer_too_small` when `Requests` wait already;
    /// `out_of_range` with the field.
    template <request_message M>
    constexpr result<std::uint8_t> request(M m) noexcept {
        if (waiting_ == Requests) return errc::buffer_too_small;
        m.message_id = next_id_;
        if (!is_valid(m)) return refusal(m);
        requests_[waiting_++] = pending_request::of(m);
        next_id_ = next_id_ == 200 ? std::uint8_t{0} : static_cast<std::uint8_t>(next_id_ + 1);
        return m.message_id;
    }
    /// Sets everyone's clock; for the central master. Fails as `request` does. Only the master with `confirms_clock` answers; if there is none, the
    /// request ends as `failed`, although the clocks are set. [can §5; D11]
    constexpr result<std::uint8_t> set_every_clock(const moment& t) noexcept {
        return request(set_clock{global_node, 0, t.year, t.month, t.day, t.hour, t.minute, t.second});
    }

    /// The frame to be sent next, null when there is none. It stays the next one until `sent`.
    constexpr const frame* front() noexcept { return queue_.front(); }
    /// That frame has left; the time-out counts from the last one of a request.
    constexpr void sent(std::uint64_t now) noexcept {
        const frame* f = queue_.front();
        if (f == nullptr) return;
        const bool ours = f->id == id_;  // and no echo of the clock
        queue_.sent();
        line_.sent(1);
        if (!ours) return;
        since_ = now;
        const pending_request& r = under_way_ ? requests_[0] : ended_;
        if (polled_node* n = nodes_.find(r.node()); n != nullptr && !queue_.holds(id_)) n->quality.sent(r.frames());
    }
    /// Takes frames from the front of `in` and reports one thing that happened, `need_more` when there is nothing left.
    constexpr master_event next(std::span<const frame>& in, std::uint64_t now) noexcept {
        if (in.empty()) reassembler_.tick(now);
        const event got = reassembler_.next(in);
        master_event e{};
        if (got.code == errc::ok) {
            line_.received(got.length, now);
            e.packet = got.packet;
            take(got.packet, now, e);
        } else if (got.code != errc::need_more) {
            e.news = master_news::fault;
            e.code = got.code;
            e.skipped = got.length;
            line_.lost_step(got.length);
        } else {
            run(now, e);
        }
        return e;
    }

    /// Requests that wait, the one under way included.
    constexpr std::size_t waiting() const noexcept { return waiting_; }
    constexpr const can::calendar& clock() const noexcept { return calendar_; }
    /// Of the bus as this master sees it.
    constexpr const link_quality& quality() const noexcept { return line_; }
    /// Of one polled node; null when it is not polled.
    constexpr const link_quality* quality(std::uint8_t node) const noexcept {
        const polled_node* n = nodes_.find(node);
        return n == nullptr ? nullptr : &n->quality;
    }

private:
    constexpr void take(const packet& p, std::uint64_t now, master_event& e) noexcept {
        e.news = master_news::stray;
        if (id_ != central_master && p.envelope().id == central_master) {
            hear_clock(p, now, e);
            return;
        }
        if (p.envelope().id != id_) return;
        pending_request& r = under_way_ ? requests_[0] : ended_;
        if (!r.is_answered_by(p)) return;
        ++r.replies;
        polled_node* n = nodes_.find(r.node());
        if (n != nullptr) n->quality.received(known.shapes[p.index()].frames, now);
        const std::uint64_t took = now > since_ ? now - since_ : 0;
        if (!under_way_) {  // the next request need not wait for this reply any more
            since_ = now;
            return;
        }
        const bool right = r.is_rightly_answered_by(p);
        if (right && n != nullptr) n->quality.round_trip.add(took);
        if (!right && queue_.holds(id_)) return;  // a late reply: the request is about to be sent again anyway
        since_ = now;
        if (!right) {
            e.wrong = true;
            ask_again(e);
            return;
        }
        line_.round_trip.add(took);
        e.news = master_news::answered;
        finish(e);
    }
    constexpr void hear_clock(const packet& p, std::uint64_t now, master_event& e) noexcept {
        const auto m = decode<set_clock>(p);
        if (!m || m->node != global_node || !is_valid(*m)) return;
        calendar_.set({m->year, m->month, m->day, m->hour, m->minute, m->second}, now);
        e.news = master_news::clock;
        if (!confirms_clock_) return;
        (void)queue_.withdraw(central_master);  // an echo that nobody waits for any more
        if (!queue_.holds(central_master)) (void)queue_.push_message({central_master}, *m);
    }

    /// What time brings: the poll, the next request, a time-out.
    constexpr void run(std::uint64_t now, master_event& e) noexcept {
        if (nodes_.count != 0 && now >= next_poll_ && Requests - waiting_ >= nodes_.count && !holds_poll(std::span(requests_).first(waiting_))) {
            for (std::size_t i = 0; i != nodes_.count; ++i)
                if (request(read_sensors{nodes_.all[i].node, 0})) requests_[waiting_ - 1].poll = true;
            const bool in_step = next_poll_ != 0 && now - next_poll_ < timing_.poll;
            next_poll_ = (in_step ? next_poll_ : now) + timing_.poll;
        }
        const bool reply_may_come = under_way_ || ended_.attempts > ended_.replies;
        if (queue_.holds(id_) || (reply_may_come && !is_over(now))) return;
        if (!under_way_) {
            if (waiting_ == 0) return;
            under_way_ = true;
            transmit();
            return;
        }
        ++line_.timeouts;
        if (polled_node* n = nodes_.find(requests_[0].node())) ++n->quality.timeouts;
        ask_again(e);
    }
    /// Whether the time for replies is over. One that has begun is waited for.
    constexpr bool is_over(std::uint64_t now) const noexcept {
        const std::uint64_t past = now > since_ ? now - since_ : 0;
        return past > timing_.timeout && (reassembler_.pending() == 0 || past - timing_.timeout > timing_.partial);
    }
    /// The request under way goes to the queue, attempt by attempt.
    constexpr void transmit() noexcept {
        ++requests_[0].attempts;
        const std::array<frame, max_frames> frames = requests_[0].under(id_);
        (void)queue_.push(std::span<const frame>(frames).first(requests_[0].frames()));
    }
    constexpr void ask_again(master_event& e) noexcept {
        polled_node* n = nodes_.find(requests_[0].node());
        const bool again = requests_[0].attempts < timing_.attempts;
        ++(again ? line_.retries : line_.failures);
        if (n != nullptr) ++(again ? n->quality.retries : n->quality.failures);
        e.news = again ? master_news::asks_again : master_news::failed;
        if (again) transmit();
        requests_[0].name_in(e);
        if (!again) finish(e);
    }
    constexpr void finish(master_event& e) noexcept {
        ended_ = requests_[0];
        ended_.attempts -= static_cast<unsigned>(queue_.withdraw(id_));  // one that has not left need not be answered
        ended_.name_in(e);
        for (std::size_t i = 1; i < waiting_; ++i) requests_[i - 1] = requests_[i];
        --waiting_;
        under_way_ = false;
    }

    std::uint32_t id_;
    timing timing_;
    bool confirms_clock_;
    bool under_way_ = false;       ///< `requests_[0]` has been sent and not been answered.
    std::uint8_t next_id_ = 0;     ///< 0..200.
    std::uint64_t since_ = 0;      ///< When the latest frame of a request left, or a reply to it came.
    std::uint64_t next_poll_ = 0;  ///< 0 before the first round.
    basic_reassembler<2> reassembler_;
    transmit_queue<2> queue_{};
    std::size_t waiting_ = 0;
    std::array<pending_request, Requests> requests_{};
    pending_request ended_{};  ///< The latest one that is over.
    polled_nodes<Nodes> nodes_{};
    can::calendar calendar_;
    link_quality line_{};
};

}  // namespace trama::can
