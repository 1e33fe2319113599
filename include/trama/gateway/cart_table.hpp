#pragma once

#include "trama/gateway/order_slots.hpp"

namespace trama::gateway {

/// What a cart does that executes `transit`. [gateway, "Cart_phase"]
constexpr cart_phase phase_of(const transit_order& transit) noexcept {
    if (transit.phase == transit_phase::none) return cart_phase::none;
    if (transit.phase == transit_phase::transit_done) return cart_phase::transit_done;
    const bool there = transit.phase == transit_phase::transiting;
    switch (transit.type) {
        case order_type::load: return there ? cart_phase::loading : cart_phase::go_load;
        case order_type::transit: return there ? cart_phase::transiting : cart_phase::go_transit;
        case order_type::unload: return there ? cart_phase::unloading : cart_phase::go_unload;
        case order_type::go_parking: return cart_phase::go_parking;
        case order_type::go_node: return cart_phase::go_node;
        default: return cart_phase::none;
    }
}

/// False in the modes that exclude new transits: `semi_automatic`, "no new transits", and `manual`, "only manual control
/// of the carts". [gateway, "Circuit_mode"] [T10]
constexpr bool takes_transits(circuit_mode mode) noexcept { return mode != circuit_mode::semi_automatic && mode != circuit_mode::manual; }

/// One cart as the gateway knows it.
struct cart {
    cart_state state{};      ///< Position, speed and conditions: the application's. `orders`, `cart_phase`, busy and ready are derived.
    order_slots slots{};
    bool changed = false;    ///< The client has not been told of the latest change.

    /// The state as it is to be sent: busy while a transit is under way, ready while a new one would find a place and
    /// nothing speaks against it, the circuit's `mode` included. [gateway, "Cart_status"]
    constexpr cart_state report(circuit_mode mode) const noexcept {
        cart_state s = state;
        s.orders = slots.orders();
        const transit_order* current = slots.find(order_use::current);
        s.cart_phase = current == nullptr ? cart_phase::none : phase_of(*current);
        const bool busy = current != nullptr && current->phase != transit_phase::transit_done;
        constexpr cart_status against = cart_status::cart_error | cart_status::hook_error | cart_status::maintenance | cart_status::house_keeping;
        const bool ready = takes_transits(mode) && slots.has_place() && !any_of(s.cart_status, against);
        s.cart_status &= ~(cart_status::busy | cart_status::ready);
        if (busy) s.cart_status |= cart_status::busy;
        if (ready) s.cart_status |= cart_status::ready;
        return s;
    }
};

/// Up to `Carts` carts, found by their identifier.
template <std::size_t Carts>
class cart_table {
public:
    /// A new cart, or the one that has this identifier already. Null when the table is full or `cart_id` above 99999.
    constexpr cart* add(std::uint32_t cart_id) noexcept {
        if (cart* same = find(cart_id)) return same;
        if (count_ == Carts || cart_id > 99999) return nullptr;
        cart& c = carts_[count_++];
        c.state.cart_id = cart_id;
        c.changed = true;
        return &c;
    }
    constexpr cart* find(std::uint32_t cart_id) noexcept {
        for (std::size_t i = 0; i != count_; ++i)
            if (carts_[i].state.cart_id == cart_id) return &carts_[i];
        return nullptr;
    }
    /// Every cart's state is due.
    constexpr void change_all() noexcept {
        for (std::size_t i = 0; i != count_; ++i) carts_[i].changed = true;
    }
    constexpr std::size_t size() const noexcept { return count_; }
    constexpr cart& operator[](std::size_t i) noexcept { return carts_[i]; }
    constexpr const cart& operator[](std::size_t i) const noexcept { return carts_[i]; }

private:
    std::array<cart, Carts> carts_{};
    std::size_t count_ = 0;
};

}  // namespace trama::gateway
