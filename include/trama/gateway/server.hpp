#pragma once

#include "trama/core/link_quality.hpp"
#include "trama/gateway/message_ids.hpp"
#include "trama/gateway/server_event.hpp"
#include "trama/gateway/server_orders.hpp"

namespace trama::gateway {

/// The gateway's side: one connection at a time, orders into slots, replies, and states that nobody asked for.
///
/// A state waits in its cart until `poll` fetches it; a newer one replaces it. So a client that reads slowly gets fewer
/// states, each of them the latest, and memory stays as it is. [T23]
template <std::size_t Carts>
class server {
public:
    /// A connection's number, never 0 and not used again for 2^32 connections.
    using session = std::uint32_t;

    constexpr explicit server(std::uint64_t rate_window = 1000) noexcept : quality_(rate_window) {}

    /// A new connection: it replaces the one before, which is to be closed. All states become due.
    constexpr session connect() noexcept {
        decoder_.reset();
        if (++latest_ == 0) ++latest_;
        active_ = latest_;
        circuit_changed_ = true;
        carts_.change_all();
        return active_;
    }
    /// A connection ended. Orders go on.
    constexpr void disconnect(session s) noexcept {
        if (s == active_) active_ = 0;
    }
    /// The connection that holds, 0 for none.
    constexpr session active() const noexcept { return active_; }

    /// Takes bytes of connection `s` from the front of `in`, carries out at most one order and writes its reply to `out`,
    /// which holds a `max_reply`. `judge(order, cart)` may refuse it by a reason that is not empty; `cart` is null for
    /// idle_processing. The reason, a view, must live until the event has been read. The nack bears 80 characters of the reason, with `?` for each that is not printable ASCII.
    template <class Judge = accept_all>
    constexpr server_event next(session s, std::span<const std::uint8_t>& in, std::uint64_t now, std::span<std::uint8_t> out, Judge&& judge = {}) noexcept {
        server_event e{};
        if (s != active_ || s == 0) {
            if (in.empty()) return e;
            e.news = server_news::stale;
            e.skipped = in.size();
            in = in.last(0);
            return e;
        }
        if (out.size() < max_reply) {
            e.news = server_news::no_room;
            return e;
        }
        const event got = decoder_.next(in);
        if (got.code != errc::need_more) take(got, now, out, judge, e);
        return e;
    }
    static constexpr std::size_t max_reply = type_size + nack::layout.size + 2;

    /// Writes the next state that is due to `out` and returns its bytes; 0 when none is due, when there is no connection, or when `out` is smaller
    /// than `max_record`. Carts and circuit take turns, so that none waits for longer than a round, however often the others change. A state with
    /// a value out of range is passed over and stays due: `unsendable`.
    constexpr std::size_t poll(std::span<std::uint8_t> out) noexcept {
        if (active_ == 0 || out.size() < max_record) return 0;
        for (std::size_t i = 0; i <= carts_.size(); ++i) {
            const std::size_t at = turn_;
            turn_ = at < carts_.size() ? at + 1 : 0;
            bool& changed = at < carts_.size() ? carts_[at].changed : circuit_changed_;
            const std::size_t n = !changed ? 0 : at < carts_.size() ? write(carts_[at].report(circuit_.mode), out) : write(circuit_, out);
            if (n == 0) continue;
            changed = false;
            return n;
        }
        return 0;
    }
    /// The first state that `poll` cannot send until the application mends a value; false when there is none.
    constexpr unsendable_state unsendable() const noexcept {
        if (active_ == 0) return {};
        for (std::size_t i = 0; i != carts_.size(); ++i)
            if (const error fault = carts_[i].changed ? detail::fault_of(carts_[i].report(circuit_.mode)) : error{}) return {order_type::cart_state, carts_[i].state.cart_id, fault};
        if (const error fault = circuit_changed_ ? detail::fault_of(circuit_) : error{}) return {order_type::circuit_state, 0, fault};
        return {};
    }

    constexpr cart_table<Carts>& carts() noexcept { return carts_; }
    constexpr const cart_table<Carts>& carts() const noexcept { return carts_; }
    constexpr const circuit_state& circuit() const noexcept { return circuit_; }
    /// The circuit's state from now on. A mode that takes no transits makes every cart not ready. [T10]
    constexpr void set_circuit(const circuit_state& c) noexcept {
        if (takes_transits(c.mode) != takes_transits(circuit_.mode)) carts_.change_all();
        circuit_ = c;
        circuit_changed_ = true;
    }
    constexpr const link_quality& quality() const noexcept { return quality_; }
    /// Connections so far.
    constexpr session connections() const noexcept { return latest_; }

private:
    constexpr void take(const event& got, std::uint64_t now, std::span<std::uint8_t> out, auto& judge, server_event& e) noexcept {
        e.packet = got.packet;
        if (got.code != errc::ok && got.code != errc::unknown_message) {
            e.news = server_news::fault;
            e.code = got.code;
            e.skipped = got.length;
            quality_.lost_step(got.length);
            return;
        }
        quality_.received(got.length, now);
        e.news = server_news::foreign;
        messages::at(got.packet.index(), [&]<class M>() {
            if constexpr (client_types.allows(static_cast<std::int64_t>(M::key))) answer<M>(got.packet, out, judge, e);
        });
    }

    template <class M>
    constexpr void answer(const packet& p, std::span<std::uint8_t> out, auto& judge, server_event& e) noexcept {
        M m{};
        const error bad = load_body(p.body(), m);
        e.type = M::key;
        if (bad) {
            // A reply must name the order's number; without one there is nobody to answer.
            const auto id = view<M>(p.body().data()).template get<&M::msg_id>();
            e.code = bad.code;
            e.news = server_news::fault;
            if (!id) return;
            const std::uint32_t cart_id = cart_named_in<M>(p);
            m = M{};
            m.msg_id = *id;
            if constexpr (requires { m.cart_id; }) m.cart_id = cart_id;
        }
        e.msg_id = m.msg_id;
        if constexpr (requires { m.cart_id; }) e.cart_id = m.cart_id;
        e.reason = bad ? reason::bad_number : !is_valid(m) ? reason::out_of_range : decide(m, judge, e);
        e.news = e.reason.empty() ? server_news::accepted : server_news::refused;
        e.written = e.reason.empty() ? confirm<M>(e, out) : write(nack{0, e.cart_id, e.type, e.msg_id, detail::error_message(e.reason)}, out);
    }

    /// 0 where the order has no cart or its number cannot be read.
    template <class M>
    static constexpr std::uint32_t cart_named_in([[maybe_unused]] const packet& p) noexcept {
        if constexpr (requires(M m) { m.cart_id; }) return view<M>(p.body().data()).template get<&M::cart_id>().value_or(0);
        else return 0;
    }
    template <class M>
    constexpr std::string_view decide(const M& m, auto& judge, server_event& e) noexcept {
        if constexpr (requires { m.cart_id; }) {
            cart* c = carts_.find(m.cart_id);
            if (c == nullptr) return reason::unknown_cart;
            if (const std::string_view veto = judge(m, static_cast<const cart*>(c)); !veto.empty()) return veto;
            const text<10> name = detail::transit_name(transits_);
            const std::string_view refusal = detail::carry_out(m, *c, circuit_.mode, name);
            if (refusal.empty() && makes_transit(M::key)) {
                e.transit_id = name;
                transits_ = transits_ + 1 == detail::most_transits ? 1 : transits_ + 1;
            }
            return refusal;
        } else {
            return judge(m, static_cast<const cart*>(nullptr));
        }
    }
    template <class M>
    constexpr std::size_t confirm(const server_event& e, std::span<std::uint8_t> out) noexcept {
        if constexpr (makes_transit(M::key)) return write(transit_ack{0, e.cart_id, e.type, e.msg_id, e.transit_id}, out);
        else return write(ack{0, e.cart_id, e.type, e.msg_id}, out);
    }

    /// The bytes of a message under the next number; 0, and nothing is written, when it has a violation.
    template <class M>
    constexpr std::size_t write(M m, std::span<std::uint8_t> out) noexcept {
        m.msg_id = ids_.peek();
        const std::size_t size = encode(m, out).value_or(0);
        if (size == 0) return 0;
        ids_.advance();
        quality_.sent(size);
        return size;
    }

    decoder decoder_{};
    session active_ = 0;
    session latest_ = 0;
    message_ids ids_{};
    std::uint32_t transits_ = 1;
    std::size_t turn_ = 0;  ///< Whose state `poll` looks at next: the cart of that position, behind the last one the circuit.
    cart_table<Carts> carts_{};
    circuit_state circuit_{};
    bool circuit_changed_ = true;
    link_quality quality_;
};

}  // namespace trama::gateway
