#pragma once
// Delivers a number of orders exactly once, whatever becomes of the connection.

#include <random>

#include "link.hpp"
#include "trama/gateway/cart_table.hpp"

namespace shop {

/// Each cart gets one order at a time, under a cargo_id of its own. When the reply stays out, the connection is made anew
/// and the cart's first state over it tells whether the order arrived: the old connection's bytes can no longer count,
/// and a slot keeps its content until the next order for that cart.
class courier {
public:
    static constexpr unsigned long most_carts = 99999;  ///< Five columns.

    /// What the cargo_ids of a run begin with if nobody says: something of its own, since the gateway may show transits of
    /// an earlier run in its slots. Leaves room for the number of the last order.
    static std::string any_prefix(unsigned long orders) {
        std::random_device random;
        std::string prefix;
        for (std::size_t room = 10 - std::to_string(orders).size(); prefix.size() < std::min<std::size_t>(room, 5);) prefix += "0123456789abcdefghijklmnopqrstuvwxyz"[random() % 36];
        return prefix;
    }
    courier(gate_link& l, unsigned long orders, unsigned long carts, std::string prefix) : link_(l), total_(orders), carts_(carts), prefix_(std::move(prefix)) {
        const trama::text<10> last(name(total_));
        if (last.too_long() || !last.printable()) refuse("--prefix " + prefix_ + ": with the number " + std::to_string(total_) + " behind it, it is not ten printable ASCII characters at most");
    }

    bool finished() const { return delivered_ == total_; }
    unsigned long delivered() const { return delivered_; }
    unsigned long doubtful() const { return doubtful_; }

    /// Sends what can be sent.
    void work() {
        for (auto& [id, c] : table_) {
            if (c.state != cart::ready || !link_.can_send()) continue;
            if (c.order == 0 && given_ != total_) c.order = ++given_;
            if (c.order == 0) continue;
            const auto number = static_cast<std::uint32_t>(c.order);
            const trama::text<10> cargo(name(c.order));
            const std::string wrong = c.order % 2 == 1 ? link_.send(gateway::load{0, id, number * 7 % 12, 0, 0, "", "", cargo}) : link_.send(gateway::unload{0, id, number * 5 % 12, 0, 0, "", "", cargo});
            if (wrong.empty()) c.state = cart::asked;
            else give_up("order " + name(c.order) + ": " + wrong);  // it would be the same for ever
        }
    }
    void heard(const gateway::client_event& e) {
        using enum gateway::client_news;
        if (e.news == state) return look(e.packet);
        if (e.order.cart_id == 0 || e.order.cart_id > carts_) return;
        cart& c = at(e.order.cart_id);
        if (c.state != cart::asked) return;  // cross_granted is no order of the courier's
        if (!gateway::makes_transit(e.order.type)) return;
        if (e.news == accepted) settle(c);
        if (e.news == refused) c.state = cart::waits;
        if (e.news != in_doubt && e.news != timed_out) return;
        ++doubtful_;
        c.state = cart::unsure;
        if (e.news == timed_out) link_.reconnect();
    }

private:
    struct cart {
        enum { waits, ready, asked, unsure } state = waits;
        unsigned long order = 0;
    };
    cart& at(std::uint32_t id) { return table_[id]; }
    std::string name(unsigned long order) const { return prefix_ + std::to_string(order); }
    void settle(cart& c) {
        ++delivered_;
        c.order = 0;
        c.state = cart::waits;
    }
    void look(const gateway::packet& p) {
        const auto m = trama::decode<gateway::cart_state>(p);
        if (!m || m->cart_id == 0 || m->cart_id > carts_) return;
        cart& c = at(m->cart_id);
        if (m->cross_confirmation_needed == 1) (void)link_.send(gateway::cross_granted{0, m->cart_id, m->end_node});
        if (c.state == cart::asked) return;
        if (c.state == cart::unsure) {
            if (gateway::find_cargo(*m, trama::text<10>(name(c.order))) != nullptr) return settle(c);
            c.state = cart::waits;  // it never arrived: the same order once more
        }
        c.state = gateway::any_of(m->cart_status, gateway::cart_status::ready) ? cart::ready : cart::waits;
    }

    gate_link& link_;
    unsigned long total_, carts_, given_ = 0, delivered_ = 0, doubtful_ = 0;
    std::string prefix_;
    std::map<std::uint32_t, cart> table_;
};

}  // namespace shop
