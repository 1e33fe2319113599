#pragma once

#include "trama/gateway/messages/states.hpp"

namespace trama::gateway {

/// True for the orders that take a slot: they are answered by transit_ack or nack, all others by ack or nack.
constexpr bool makes_transit(order_type type) noexcept { return type != order_type::none && transit_types.allows(static_cast<std::int64_t>(type)); }

/// The two transits that a cart can hold. At most one slot each is `previous`, `current` and `next`; a slot that
/// runs out of use keeps its content until a new order needs the place, unless it was cancelled. [gateway, "Order_use"]
///
/// A slot that becomes `current` begins with phase `go_transit`, the first one of a transit that is executed; a
/// `next` has phase `none`, since it is not executed yet. [gateway, "Transit_phase"]
class order_slots {
public:
    static constexpr std::size_t count = 2;

    constexpr const std::array<transit_order, count>& orders() const noexcept { return slots_; }

    /// The slot of that use, null when there is none. Of several unused ones the first.
    constexpr const transit_order* find(order_use use) const noexcept {
        for (const transit_order& s : slots_)
            if (s.use == use) return &s;
        return nullptr;
    }
    /// The transit of that name, null when no slot in use bears it.
    constexpr const transit_order* find(const text<10>& transit_id) const noexcept {
        for (const transit_order& s : slots_)
            if (s.use != order_use::unused && s.transit_id == transit_id) return &s;
        return nullptr;
    }
    /// True when `accept` would find a place.
    constexpr bool has_place() const noexcept { return place() != count; }

    /// Takes a new order, whatever `use` and `phase` it comes with: into the first unused slot, else into the previous
    /// one. It becomes `next`, or `current` when none is under way. Null when there is no place.
    constexpr const transit_order* accept(const transit_order& order) noexcept {
        const std::size_t at = place();
        if (at == count) return nullptr;
        transit_order* running = slot_of(order_use::current);
        transit_order& fresh = slots_[at];
        fresh = order;
        if (running == nullptr) {
            start(fresh);
        } else if (running->phase == transit_phase::transit_done) {
            running->use = order_use::previous;
            start(fresh);
        } else {
            fresh.use = order_use::next;
            fresh.phase = transit_phase::none;
        }
        return &fresh;
    }

    /// The current transit reached `phase`. With `transit_done` a waiting `next` takes over by itself. False, and
    /// nothing changes, when no transit is under way: there is no current one, or it is done.
    constexpr bool advance(transit_phase phase) noexcept {
        transit_order* running = slot_of(order_use::current);
        if (running == nullptr || running->phase == transit_phase::transit_done) return false;
        running->phase = phase;
        transit_order* waiting = slot_of(order_use::next);
        if (phase == transit_phase::transit_done && waiting != nullptr) {
            running->use = order_use::previous;
            start(*waiting);
        }
        return true;
    }

    /// Gives up every transit under way or waiting; their slots become unused. Finished ones stay to be seen.
    /// Returns how many were given up. [gateway, "Order_type: cancel_transits"]
    constexpr std::size_t cancel() noexcept {
        std::size_t given_up = 0;
        for (transit_order& s : slots_) {
            const bool under_way = s.use == order_use::current && s.phase != transit_phase::transit_done;
            if (!under_way && s.use != order_use::next) continue;
            s = transit_order{};
            ++given_up;
        }
        return given_up;
    }

    /// Sets `inputs`, `outputs`, `last_command` or `cargo_id` of a transit that is under way or waits. False, and nothing
    /// changes, when there is none of that name, or when `value` is too long or not printable, which no cart_state could carry.
    template <text<10> transit_order::*Member>
    constexpr bool assign(const text<10>& transit_id, const text<10>& value) noexcept {
        static_assert(Member != &transit_order::transit_id && Member != &transit_order::options, "given once, with the order");
        if (!value.printable()) return false;
        for (transit_order& s : slots_) {
            const bool alive = (s.use == order_use::current && s.phase != transit_phase::transit_done) || s.use == order_use::next;
            if (!alive || s.transit_id != transit_id) continue;
            s.*Member = value;
            return true;
        }
        return false;
    }

private:
    constexpr transit_order* slot_of(order_use use) noexcept {
        for (transit_order& s : slots_)
            if (s.use == use) return &s;
        return nullptr;
    }
    /// Where a new order goes; `count` when it goes nowhere.
    constexpr std::size_t place() const noexcept {
        for (const order_use use : {order_use::unused, order_use::previous})
            for (std::size_t i = 0; i != count; ++i)
                if (slots_[i].use == use) return i;
        return count;
    }
    static constexpr void start(transit_order& s) noexcept {
        s.use = order_use::current;
        s.phase = transit_phase::go_transit;
    }

    std::array<transit_order, count> slots_{};
};

}  // namespace trama::gateway
