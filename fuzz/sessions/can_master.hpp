#pragma once
// A master of can and what its requests have come to.
#include <map>

#include "formats/can.hpp"
#include "sessions/script.hpp"
#include "trama/can/master.hpp"

namespace trama::fuzz {

class asking_master {
    static constexpr std::size_t nodes = 2, requests = 4;

public:
    asking_master(std::uint32_t id, const can::timing& t, bool confirms_clock) : id_(id), attempts_(t.attempts), machine_(id, t, confirms_clock) {}

    can::master<nodes, requests>& machine() { return machine_; }
    void poll(std::uint8_t node) {
        require(machine_.poll(node), "a master polls as many nodes as it says");
        ++polled_;
    }
    bool full() const { return machine_.waiting() == requests; }
    /// No request waits that was asked for.
    bool done() const { return open_.empty(); }

    template <class M>
    void ask(M m) {
        const bool too_many = full();
        const auto id = machine_.request(m);
        if (too_many) return require(id.code() == errc::buffer_too_small, "a master says that too much waits");
        m.message_id = id.value_or(0);
        require(bool(id) == is_valid(m), "a master takes what is valid");
        if (id) note(m);
    }
    void set_clocks(const can::moment& t) {
        const bool too_many = full();
        const auto id = machine_.set_every_clock(t);
        require(bool(id) == !too_many, "a clock is set unless too much waits");
        if (id) note(can::set_clock{can::global_node, *id, t.year, t.month, t.day, t.hour, t.minute, t.second});
    }
    /// One step; false when it needs more.
    bool hear(std::span<const can::frame>& in, std::uint64_t now) {
        using can::master_news;
        const can::master_event e = machine_.next(in, now);
        require(machine_.waiting() <= open_.size() + polled_, "no second poll of a node waits");
        if (e.news == master_news::need_more) return false;
        if (e.news != master_news::answered && e.news != master_news::failed && e.news != master_news::asks_again) return true;
        // 0 of one that was answered before it left: by the late reply to another that looks the same.
        require(e.attempt <= attempts_ && (e.attempt != 0 || e.news == master_news::answered), "a request is sent as often as the timing says");
        require(e.news != master_news::failed || e.attempt == attempts_, "a request fails after its last attempt");
        const auto at = open_.find(e.message_id);
        const bool asked = at != open_.end() && static_cast<char>(at->second[2]) == e.letter;
        ++(e.news == master_news::answered ? answers_ : e.news == master_news::failed ? failures_ : retries_);
        require(asked || (polled_ != 0 && e.letter == 'R'), "what a master tells is about a request");
        if (e.news == master_news::asks_again) return true;
        if (const auto m = decode<can::sensor_readings>(e.packet); asked && m && e.news == master_news::answered) read_ = *m;
        if (e.news == master_news::answered) judge(e, asked ? at->second : octets{e.node, e.message_id, 'R'});
        if (asked) open_.erase(at);
        return true;
    }

    /// The latest reply to a reading that was asked for.
    const can::sensor_readings& read_last() const { return read_; }
    void check() const {
        const link_quality& q = machine_.quality();
        require(q.failures == failures_ && q.retries == retries_ && q.round_trip.count == answers_, "a master counts how its requests end");
    }

private:
    template <class M>
    void note(const M& m) {
        require(m.message_id <= 200 && !open_.contains(m.message_id), "requests that wait have different numbers, 0 to 200");
        octets body(body_size(m));
        store_body(body.data(), m);
        open_[m.message_id] = body;
    }
    void judge(const can::master_event& e, const octets& request) const {
        const auto body = e.packet.body();
        const bool echo = e.letter != 'R' && e.letter != 'A';
        require(e.packet.envelope().id == id_ && (echo ? body.size() == request.size() : body.size() > request.size()) && std::equal(request.begin(), request.end(), body.begin()),
                "a reply is the request itself, or begins with it");
        const auto bad = visit<can::format>(e.packet, [](const auto& m) { require(is_valid(m), "a reply that is taken is valid"); });
        require(!bad, "a reply that is taken loads");
    }

    std::uint32_t id_;
    unsigned attempts_;
    can::master<nodes, requests> machine_;
    std::size_t polled_ = 0;
    std::uint64_t answers_ = 0, failures_ = 0, retries_ = 0;
    can::sensor_readings read_{};
    std::map<std::uint8_t, octets> open_;  ///< The bodies of the requests that wait, by number.
};

}  // namespace trama::fuzz
