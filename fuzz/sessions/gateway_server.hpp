#pragma once
// A server of gateway, the application behind it, and what the reference says of its carts' slots.
#include <algorithm>

#include "formats/gateway.hpp"
#include "reference/order_slots.hpp"
#include "sessions/script.hpp"
#include "trama/gateway/server.hpp"

namespace trama::fuzz {

class watched_server {
public:
    static constexpr std::size_t carts = 3;

    watched_server() {
        for (std::uint32_t id = 1; id <= carts; ++id) require(server_.carts().add(id) != nullptr, "a table has room for as many carts as it says");
        require(server_.carts().add(carts + 1) == nullptr, "a full table takes no other cart");
        session_ = server_.connect();
    }
    void reconnect(bool in_order) {
        if (in_order) server_.disconnect(session_);
        const auto before = std::exchange(session_, server_.connect());
        require(session_ != before && session_ == server_.active(), "every connection has its number");
    }
    /// Takes `in` and hands replies to `put`. `good`: the bytes are as a client sent them. `refusing`: the application wants none of it.
    void take(std::span<const std::uint8_t> in, std::uint64_t now, bool good, bool refusing, auto&& put) {
        exact<std::uint8_t> out(gateway::server<carts>::max_reply);
        const auto judge = [&]<class M>(const M& m, const gateway::cart* cart) -> std::string_view {
            judged_ = true;
            expected_ = refusing ? veto : cart != nullptr ? refusal_of(m, *cart) : "";
            return refusing ? veto : "";
        };
        until_done([&] {
            judged_ = false;
            const auto e = server_.next(session_, in, now, out.all(), judge);
            if (e.news == gateway::server_news::need_more) return false;
            const auto reply = std::span<const std::uint8_t>(out.all()).first(e.written);
            took(e, reply, good);
            if (!reply.empty()) put(e, reply);
            return true;
        }, 2 * in.size() + 4);
        require(in.empty(), "need_more means that the chunk is used up");
    }
    /// The next state that is due; empty when there is none, or no room.
    octets poll(std::size_t room = gateway::max_record) {
        exact<std::uint8_t> out(room);
        const auto state = std::span<const std::uint8_t>(out.all()).first(server_.poll(out.all()));
        if (state.empty()) return {};
        ++sent_;
        only(state, [&]<class M>(const M& m) {
            if constexpr (M::key == gateway::order_type::cart_state) {
                auto now = server_.carts().find(m.cart_id)->report(server_.circuit().mode);
                now.msg_id = m.msg_id;
                require(m == now, "a cart's state is what holds when it is fetched");
            } else {
                require(M::key == gateway::order_type::circuit_state, "a server tells of carts and of the circuit");
            }
        });
        return {state.begin(), state.end()};
    }
    /// States that a new connection is told of: all that can be sent.
    std::size_t due() const { return carts + (server_.unsendable() ? 0 : 1); }
    text<10> some_transit(dice& d) const { return transits_.empty() ? text<10>("T1") : transits_[d.below(transits_.size())]; }
    /// What the application does: carts move on, their conditions and the circuit change.
    void work(dice& d) {
        gateway::cart& cart = server_.carts()[d.below(carts)];
        const std::size_t what = d.below(8);
        if (what < 4) {
            constexpr const char* words[] = {"none", "go_transit", "transiting", "transit_done"};
            const std::size_t phase = d.below(4);
            require(cart.slots.advance(static_cast<gateway::transit_phase>(phase)) == slots_[cart.state.cart_id - 1].phase(words[phase]),
                    "a transit goes on where the reference says that one is under way");
        } else if (what == 4) {
            cart.state.cart_status = static_cast<gateway::cart_status>(d.one_in(4) ? d.below(4096) : 0);
        } else if (what == 5) {
            cart.state.cross_confirmation_needed = 1;
            cart.state.end_node = static_cast<std::uint32_t>(d.below(4));
        } else {
            arena memory;
            auto state = random_message<gateway::circuit_state>(d, memory);
            if (d.one_in(2)) state.mode = gateway::circuit_mode::automatic;
            if (d.one_in(8)) change_one_value(state, d, memory);
            server_.set_circuit(state);
        }
        cart.changed = true;
    }
    /// Bytes of a connection that another one has replaced, and a reply without room.
    void hear_others(std::size_t n, std::uint64_t now) {
        const octets bytes(n, gateway::stx);
        std::span<const std::uint8_t> in(bytes);
        exact<std::uint8_t> out(gateway::server<carts>::max_reply - 1);
        require(server_.next(session_, in, now, out.all()).news == gateway::server_news::no_room && in.size() == n, "without room nothing is consumed");
        require(server_.next(session_ - 1, in, now, out.all()).news == gateway::server_news::stale && in.empty(), "bytes of an old connection are thrown away");
    }
    void check() const {
        for (std::size_t i = 0; i != carts; ++i)
            for (std::size_t k = 0; k != 2; ++k) {
                const auto& slot = server_.carts()[i].slots.orders()[k];
                const auto& expected = slots_[i].slot[k];
                require(name_of(slot.use) == expected.use && name_of(slot.phase) == expected.phase, "the slots are as the reference says");
                require(expected.order == 0 || slot.transit_id == transits_[static_cast<std::size_t>(expected.order) - 1], "a slot holds the transit that the reference says");
            }
        require(server_.quality().packets_sent == sent_, "a server counts what it sends");
    }

private:
    static constexpr std::string_view veto = "not \x01 now";

    /// Why an order for that cart is refused, by the reference's slots and plain rules; empty when it is not.
    template <class M>
    std::string_view refusal_of(const M& m, const gateway::cart& c) const {
        namespace reason = gateway::reason;
        auto slots = slots_[c.state.cart_id - 1];
        if constexpr (gateway::makes_transit(M::key)) {
            const auto mode = server_.circuit().mode;
            if (mode == gateway::circuit_mode::manual || mode == gateway::circuit_mode::semi_automatic) return reason::no_transits;
            if (!slots.order(0)) return reason::no_place;
            // cart_error, hook_error, maintenance, house_keeping
            return (static_cast<unsigned>(c.state.cart_status) & (1U | 2U | 32U | 1024U)) != 0 ? reason::not_ready : "";
        } else if constexpr (M::key == gateway::order_type::cross_granted) {
            return c.state.cross_confirmation_needed == 1 && c.state.end_node == m.node ? "" : reason::not_waiting;
        } else if constexpr (requires { m.transit_id; }) {
            const auto at = std::find(transits_.begin(), transits_.end(), m.transit_id);
            const auto number = static_cast<int>(at - transits_.begin()) + 1;
            for (const auto& s : slots.slot) {
                if (at == transits_.end() || s.use == "unused" || s.order != number) continue;
                if (to_a_node_[static_cast<std::size_t>(number) - 1]) return reason::no_station;
                return s.use == "next" || (s.use == "current" && s.phase != "transit_done") ? "" : reason::unknown_transit;
            }
            return reason::unknown_transit;
        } else {
            return "";
        }
    }
    void took(const gateway::server_event& e, std::span<const std::uint8_t> reply, bool good) {
        using gateway::server_news;
        const bool answered = e.news == server_news::accepted || e.news == server_news::refused;
        require(!good || answered, "what a client sends is answered");
        require(answered ? !reply.empty() : e.news == server_news::fault || reply.empty(), "an order gets a reply, nothing else does");
        if (reply.empty()) return;
        ++sent_;
        require(judged_ ? e.reason == expected_ : e.news == server_news::refused, "an order is refused for the reason that the document gives");
        require(judged_ || !good || e.reason == gateway::reason::unknown_cart, "a valid order is judged, unless it is for no cart");
        require(!judged_ || e.type == gateway::order_type::idle_processing || (e.cart_id >= 1 && e.cart_id <= carts), "only carts that there are get orders");
        only(reply, [&]<class M>(const M& m) {
            if constexpr (requires { m.src_type; }) {
                require(m.src_type == e.type && m.src_msg_id == e.msg_id && m.cart_id == e.cart_id, "a reply names the order");
                const bool refused = M::key == gateway::order_type::nack;
                require(refused == (e.news == server_news::refused), "a refusal is a nack");
                require(refused || (M::key == gateway::order_type::transit_ack) == gateway::makes_transit(e.type), "a transit is answered by transit_ack, other orders by ack");
                if constexpr (requires { m.transit_id; }) require(m.transit_id == e.transit_id, "a transit_ack gives the transit its name");
            } else {
                require(false, "a reply is an ack, a transit_ack or a nack");
            }
        });
        follow(e);
    }
    /// What an order does to the slots, by the reference.
    void follow(const gateway::server_event& e) {
        if (e.cart_id == 0 || e.cart_id > carts) return;
        auto& cart = slots_[e.cart_id - 1];
        const bool accepted = e.news == gateway::server_news::accepted;
        if (accepted && gateway::makes_transit(e.type)) {
            transits_.push_back(e.transit_id);
            to_a_node_.push_back(e.type == gateway::order_type::go_node || e.type == gateway::order_type::go_parking);
            require(cart.order(static_cast<int>(transits_.size())), "a transit is accepted only where there is a place");
            const auto* slot = server_.carts()[e.cart_id - 1].slots.find(e.transit_id);
            require(slot != nullptr && slot->type == e.type, "an accepted transit has a slot");
        } else if (accepted && e.type == gateway::order_type::cancel_transits) {
            (void)cart.cancel();
        }
    }
    /// The one message that `bytes` are, to `f`.
    static void only(std::span<const std::uint8_t> bytes, auto&& f) {
        const exact<std::uint8_t> copy(bytes);
        std::span<const std::uint8_t> in = copy.all();
        gateway::decoder decoder;
        const auto e = decoder.next(in);
        require(e.code == errc::ok && in.empty(), "what a server sends is one record");
        const auto bad = visit<gateway::format>(e.packet, [&](const auto& m) {
            require(is_valid(m), "what a server sends is valid");
            f(m);
        });
        require(!bad, "what a server sends has good numbers");
    }

    gateway::server<carts> server_{};
    gateway::server<carts>::session session_ = 0;
    std::array<trama_reference::plain_cart, carts> slots_{};
    std::vector<text<10>> transits_;  ///< In the order in which they were accepted.
    std::vector<bool> to_a_node_;     ///< Whether that transit has no station.
    bool judged_ = false;             ///< The application was asked about the latest order.
    std::string_view expected_;       ///< And this is why it is to be refused.
    std::uint64_t sent_ = 0;
};

}  // namespace trama::fuzz
