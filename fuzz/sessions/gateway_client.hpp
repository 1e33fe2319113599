#pragma once
// A client of gateway and what its orders have come to.
#include <algorithm>

#include "formats/gateway.hpp"
#include "sessions/script.hpp"
#include "trama/gateway/client.hpp"

namespace trama::fuzz {

class watched_client {
    static constexpr std::size_t places = 4;

public:
    bool damaged = false;    ///< Bytes did not arrive as they were sent.
    bool disturbed = false;  ///< An order was given up, so that its reply may come late.
    std::deque<octets> states;  ///< Sent by the server and not yet arrived.
    /// What the server has answered to an order.
    struct reply {
        gateway::order_type type;
        std::uint32_t id;
        bool accepted;
        text<10> transit_id;
    };
    std::deque<reply> replies;  ///< Likewise not yet arrived.

    /// The bytes of the order; none when it is refused, which must have a reason.
    template <class M>
    octets send(M m, std::uint64_t now) {
        exact<std::uint8_t> out(gateway::max_record);
        const bool full = client_.in_flight() == places;
        const std::uint32_t id = client_.next_id();
        m.msg_id = id;
        const auto size = client_.send(m, now, out.all());
        require(bool(size) == (!full && is_valid(m)), "a client sends what is valid while it has places");
        if (!size) {
            require(size.code() == (full ? errc::buffer_too_small : errc::out_of_range), "a client says why it does not send");
            require(client_.next_id() == id, "an order that is not sent uses no number");
            return {};
        }
        for (const auto& o : open_) require(o.msg_id != id, "no two orders in flight have one number");
        std::uint32_t cart_id = 0;
        if constexpr (requires { m.cart_id; }) cart_id = m.cart_id;
        open_.push_back({M::key, id, cart_id, now, false});
        const auto bytes = out.all().first(*size);
        return {bytes.begin(), bytes.end()};
    }
    void listen(std::span<const std::uint8_t> in, std::uint64_t now) {
        using gateway::client_news;
        until_done([&] {
            const auto e = client_.next(in, now);
            switch (e.news) {
                case client_news::need_more: return false;
                case client_news::accepted: case client_news::refused:
                    ++answered_;
                    close(e.order);
                    if (!damaged && !disturbed) answered(e);
                    break;
                case client_news::timed_out:
                    ++late_;
                    disturbed = true;
                    close(e.order);
                    require(now > e.order.sent && now - e.order.sent > patience, "an order is given up when its time is over");
                    break;
                case client_news::in_doubt:
                    ++doubtful_;
                    close(e.order);
                    require(losing_, "orders are in doubt when a connection is lost");
                    break;
                case client_news::state: if (!damaged) arrived(e.packet.bytes()); break;
                case client_news::stray: require(damaged || disturbed, "every reply belongs to an order"); break;
                case client_news::foreign: case client_news::fault: require(damaged, "what a server sends is what a client takes"); break;
            }
            return true;
        }, 2 * in.size() + 2 * places + 8);
        require(in.empty(), "need_more means that the chunk is used up");
    }
    void lose_connection(std::uint64_t now) {
        states.clear();
        replies.clear();
        client_.disconnected();
        damaged = losing_ = true;  // a record may be cut off
        for (auto& o : open_) o.lost = true;
        listen({}, now);
        losing_ = false;
        require(open_.empty(), "orders of a lost connection are in doubt");
    }
    std::size_t waiting() const { return open_.size(); }
    std::uint64_t answered() const { return answered_; }
    void check() const {
        require(client_.in_flight() == open_.size(), "a client knows how many orders wait");
        const link_quality& q = client_.quality();
        require(q.round_trip.count == answered_ && q.timeouts == late_ && q.failures == late_ + doubtful_, "a client counts how its orders end");
    }

private:
    static constexpr std::uint64_t patience = 50;

    /// The reply is the one that the server gave, to the order that it gave it to.
    void answered(const gateway::client_event& e) {
        require(!replies.empty(), "a client hears no more replies than the server gave");
        const reply expected = replies.front();
        replies.pop_front();
        require(expected.type == e.order.type && expected.id == e.order.msg_id && expected.accepted == (e.news == gateway::client_news::accepted), "replies arrive as they were given");
        if (const auto m = decode<gateway::transit_ack>(e.packet)) require(m->transit_id == expected.transit_id, "a transit has the name that the server gave it");
    }
    void arrived(std::span<const std::uint8_t> bytes) {
        require(!states.empty() && std::equal(states.front().begin(), states.front().end(), bytes.begin(), bytes.end()), "states arrive as they were sent, in their order");
        states.pop_front();
    }
    void close(const gateway::order_in_flight& o) {
        const auto at = std::find(open_.begin(), open_.end(), o);
        require(at != open_.end(), "an order ends once, and is told as it was sent");
        open_.erase(at);
    }

    gateway::client<places> client_{patience};
    std::vector<gateway::order_in_flight> open_;
    bool losing_ = false;
    std::uint64_t answered_ = 0, late_ = 0, doubtful_ = 0;
};

}  // namespace trama::fuzz
