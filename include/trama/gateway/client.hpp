#pragma once

#include <algorithm>

#include "trama/core/link_quality.hpp"
#include "trama/gateway/format.hpp"
#include "trama/gateway/message_ids.hpp"
#include "trama/gateway/order_slots.hpp"

namespace trama::gateway {

/// What happened on the client's side of the connection.
enum class client_news : std::uint8_t {
    need_more,  ///< Nothing; call again with more bytes or later.
    accepted,   ///< transit_ack or ack for `order`; `packet` is the reply.
    refused,    ///< nack for `order`; `packet` is the reply.
    timed_out,  ///< No reply in time: whether the order was carried out is not known.
    in_doubt,   ///< The connection was lost before the reply: likewise.
    state,      ///< cart_state or circuit_state, in `packet`.
    stray,      ///< A reply to no order in flight, such as a late one, or a reply of the wrong kind; in `packet`.
    foreign,    ///< A record that the document lacks, or an order, which only clients send; in `packet`.
    fault,      ///< `code` says what was wrong with `skipped` bytes, or with the fields of `packet`.
};

/// An order that waits for its reply.
struct order_in_flight {
    order_type type = order_type::none;  ///< `none`: no order.
    std::uint32_t msg_id = 0;            ///< 0..99999.
    std::uint32_t cart_id = 0;           ///< 0 of idle_processing.
    std::uint64_t sent = 0;              ///< When, in the caller's unit of time.
    bool lost = false;                   ///< The connection that carried it is gone.
    friend constexpr bool operator==(const order_in_flight&, const order_in_flight&) = default;
};

/// What `client::next` reports. Views live until the client's next call, and no longer than the chunk given to it.
struct client_event {
    client_news news = client_news::need_more;
    order_in_flight order{};     ///< Of accepted, refused, timed_out, in_doubt.
    gateway::packet packet{};    ///< Where a record came.
    errc code = errc::ok;        ///< Of fault.
    std::uint64_t skipped = 0;   ///< Of fault: bytes without use.
};

/// The client's side: numbers orders, matches replies by src_type, src_msg_id and cart_id, tells which orders got none.
///
/// An order without a reply is never repeated by itself, since it may have been carried out. The cart's next
/// cart_state tells: `find_cargo`. [T23]
template <std::size_t InFlight = 16>
class client {
    static_assert(InFlight < message_ids::count, "each order in flight has a number of its own");

public:
    /// `timeout` in the unit of all times given later; `first_id` is the first order's number, 0..99999.
    constexpr explicit client(std::uint64_t timeout, std::uint32_t first_id = 0, std::uint64_t rate_window = 1000) noexcept
        : timeout_(timeout), ids_(first_id), quality_(rate_window) {}

    /// Writes `order` under the next number: the bytes to send. `buffer_too_small` also when `InFlight` orders already
    /// wait; `out_of_range` with the field. On error nothing is written and no number used.
    template <has_layout M>
        requires(messages::contains<M> && client_types.allows(static_cast<std::int64_t>(M::key)))
    constexpr result<std::size_t> send(M order, std::uint64_t now, std::span<std::uint8_t> out) noexcept {
        order_in_flight* place = slot_of(order_type::none, 0);
        if (place == nullptr) return errc::buffer_too_small;
        message_ids ids = unused_ids();
        order.msg_id = ids.peek();
        const result<std::size_t> size = encode(order, out);
        if (!size) return size;
        *place = {M::key, order.msg_id, 0, now, false};
        if constexpr (requires { order.cart_id; }) place->cart_id = order.cart_id;
        ids.advance();
        ids_ = ids;
        quality_.sent(*size);
        return size;
    }

    /// The connection is gone: `next` reports a partial record, then every order in flight now as `in_doubt`; orders sent
    /// from here on belong to the next connection. Give `next` no more bytes of the old one: it would take a state from
    /// before the loss for one that the next connection brought.
    constexpr void disconnected() noexcept {
        decoder_.finish();
        for (order_in_flight& o : orders_) o.lost = o.type != order_type::none;
        lost_ = true;
    }
    /// Takes bytes from the front of `in` and reports one thing that happened, `need_more` when there is nothing left.
    constexpr client_event next(std::span<const std::uint8_t>& in, std::uint64_t now) noexcept {
        if (lost_) {
            std::span<const std::uint8_t> none{};
            if (const event e = decoder_.next(none); e.code != errc::need_more) return judge(e, now);
            if (const client_event silent = give_up(now); silent.news != client_news::need_more) return silent;
            lost_ = false;
            decoder_.reset();
        }
        const event e = decoder_.next(in);
        return e.code != errc::need_more ? judge(e, now) : give_up(now);
    }

    /// Orders that wait for a reply.
    constexpr std::size_t in_flight() const noexcept {
        std::size_t n = 0;
        for (const order_in_flight& o : orders_) n += o.type != order_type::none ? 1U : 0U;
        return n;
    }
    /// The number that the next order gets: the one behind the last order's that is not in flight.
    constexpr std::uint32_t next_id() const noexcept { return unused_ids().peek(); }
    constexpr const link_quality& quality() const noexcept { return quality_; }

private:
    constexpr message_ids unused_ids() const noexcept {
        message_ids ids = ids_;
        const auto waits = [&](const order_in_flight& o) { return o.type != order_type::none && o.msg_id == ids.peek(); };
        while (std::any_of(orders_.begin(), orders_.end(), waits)) ids.advance();
        return ids;
    }
    constexpr order_in_flight* slot_of(order_type type, std::uint32_t msg_id) noexcept {
        for (order_in_flight& o : orders_)
            if (o.type == type && (type == order_type::none || o.msg_id == msg_id)) return &o;
        return nullptr;
    }
    /// An order that will get no reply, the oldest first. After a loss those of the lost connection only: the bytes at
    /// hand, which are read after that, may hold the others' replies.
    constexpr client_event give_up(std::uint64_t now) noexcept {
        order_in_flight* oldest = nullptr;
        for (order_in_flight& o : orders_) {
            const bool late = o.type != order_type::none && now > o.sent && now - o.sent > timeout_;
            if ((lost_ ? o.lost : late) && (oldest == nullptr || o.sent < oldest->sent)) oldest = &o;
        }
        if (oldest == nullptr) return {};
        client_event e{};
        e.news = lost_ ? client_news::in_doubt : client_news::timed_out;
        e.order = *oldest;
        *oldest = {};
        ++quality_.failures;
        if (!lost_) ++quality_.timeouts;
        return e;
    }
    constexpr client_event judge(const event& e, std::uint64_t now) noexcept {
        client_event out{};
        out.packet = e.packet;
        if (e.code == errc::unknown_message) {
            out.news = client_news::foreign;
            quality_.received(e.length, now);
        } else if (!e) {
            out.news = client_news::fault;
            out.code = e.code;
            out.skipped = e.length;
            quality_.lost_step(e.length);
        } else {
            quality_.received(e.length, now);
            const error bad = visit<format>(e.packet, [&](const auto& m) { read(m, now, out); });
            if (bad) {
                out.news = client_news::fault;
                out.code = bad.code;
            }
        }
        return out;
    }
    template <class M>
    constexpr void read(const M& m, std::uint64_t now, client_event& out) noexcept {
        if constexpr (M::key == order_type::cart_state || M::key == order_type::circuit_state) {
            out.news = client_news::state;
        } else if constexpr (requires { m.src_type; }) {
            order_in_flight* o = m.src_type == order_type::none ? nullptr : slot_of(m.src_type, m.src_msg_id);
            const bool refusal = M::key == order_type::nack;
            out.news = client_news::stray;
            if (o == nullptr || (!refusal && makes_transit(o->type) != (M::key == order_type::transit_ack))) return;
            // cart_id 0 names no cart, and idle_processing was for none. [D18]
            if (m.cart_id != 0 && m.cart_id != o->cart_id && o->type != order_type::idle_processing) return;
            out.news = refusal ? client_news::refused : client_news::accepted;
            out.order = *o;
            quality_.round_trip.add(now > o->sent ? now - o->sent : 0);
            *o = {};
        } else {
            out.news = client_news::foreign;
        }
    }

    std::uint64_t timeout_;
    message_ids ids_;
    bool lost_ = false;  ///< A connection is gone, and not all of what it left is reported.
    decoder decoder_{};
    std::array<order_in_flight, InFlight> orders_{};
    link_quality quality_;
};

/// Whether a cart holds or has just finished a transit of that cargo. Give every transit a cargo_id of its own and no
/// cart a new one, nor `cancel_transits`, while an order to it waits or is in doubt: its cart_state then tells for certain,
/// since a slot keeps its content until a new order or a cancellation, and `server` sends it anew to each new connection [T23].
constexpr const transit_order* find_cargo(const cart_state& cart, const text<10>& cargo_id) noexcept {
    for (const transit_order& o : cart.orders)
        if (o.use != order_use::unused && o.cargo_id == cargo_id) return &o;
    return nullptr;
}

}  // namespace trama::gateway
