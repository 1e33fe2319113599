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
        polls_ = true;
    }
    bool full() const { return machine_.waiting() == requests; }
    /// No request waits that was asked for.
    bool done() const { return open_.empty(); }

    template <class M>
    void ask(M m) {
        const bool too_many = full();
        const auto id = machine_.request(m);
        if (too_many) return require(id.code() == errc::buffer_too_small, "a master says that too much waits");
        m.message_id = 0;
        require(bool(id) == is_valid(m), "a master takes what is valid");
        if (id) note(*id, static_cast<char>(static_cast<unsigned>(M::key) >> 8));
    }
    void set_clocks(const can::moment& t) {
        const bool too_many = full();
        const auto id = machine_.set_every_clock(t);
        require(bool(id) == !too_many, "a clock is set unless too much waits");
        if (id) note(*id, 'C');
    }
    /// One step; false when it needs more.
    bool hear(std::span<const can::frame>& in, std::uint64_t now) {
        using can::master_news;
        const can::master_event e = machine_.next(in, now);
        if (e.news == master_news::need_more) return false;
        if (e.news != master_news::answered && e.news != master_news::failed && e.news != master_news::asks_again) return true;
        require(e.attempt >= 1 && e.attempt <= attempts_, "a request is sent as often as the timing says");
        require(e.news != master_news::failed || e.attempt == attempts_, "a request fails after its last attempt");
        const auto at = open_.find(e.message_id);
        const bool asked = at != open_.end() && at->second == e.letter;
        require(asked || (polls_ && e.letter == 'R'), "what a master tells is about a request");
        if (e.news == master_news::asks_again) return true;
        if (e.news == master_news::answered) judge(e);
        if (asked) open_.erase(at);
        return true;
    }

private:
    void note(std::uint8_t id, char letter) {
        require(id <= 200 && !open_.contains(id), "requests that wait have different numbers, 0 to 200");
        open_[id] = letter;
    }
    void judge(const can::master_event& e) const {
        const auto body = e.packet.body();
        require(e.packet.envelope().id == id_ && body[0] == e.node && body[1] == e.message_id && body[2] == static_cast<std::uint8_t>(e.letter),
                "a reply has the request's node, number and letter");
        const auto bad = visit<can::format>(e.packet, [](const auto& m) { require(is_valid(m), "a reply that is taken is valid"); });
        require(!bad, "a reply that is taken loads");
    }

    std::uint32_t id_;
    unsigned attempts_;
    can::master<nodes, requests> machine_;
    bool polls_ = false;
    std::map<std::uint8_t, char> open_;  ///< Requests that wait: the letter by number.
};

}  // namespace trama::fuzz
