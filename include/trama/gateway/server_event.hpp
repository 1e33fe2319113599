#pragma once

#include "trama/core/view.hpp"
#include "trama/gateway/cart_table.hpp"
#include "trama/gateway/format.hpp"

namespace trama::gateway {

/// What happened on the gateway's side of the connection.
enum class server_news : std::uint8_t {
    need_more,  ///< Nothing; call again with more bytes.
    accepted,   ///< An order was carried out and answered.
    refused,    ///< An order was answered by nack; `reason` says why.
    no_room,    ///< `out` cannot hold a reply; nothing was consumed.
    stale,      ///< Bytes of a connection that another one has replaced; all of `in` was thrown away.
    foreign,    ///< A record that is no order; not answered.
    fault,      ///< `code` says what was wrong with `skipped` bytes, or why an order without readable number got no reply.
};

/// What `server::next` reports. Views live until the server's next call, and no longer than the chunk given to it.
struct server_event {
    server_news news = server_news::need_more;
    order_type type = order_type::none;  ///< Of accepted, refused.
    std::uint32_t msg_id = 0;            ///< Likewise.
    std::uint32_t cart_id = 0;           ///< Likewise; 0 of idle_processing.
    text<10> transit_id{};               ///< Of an accepted transit.
    std::string_view reason{};           ///< Of refused.
    gateway::packet packet{};            ///< Where a record came.
    errc code = errc::ok;                ///< Of fault.
    std::uint64_t skipped = 0;           ///< Of fault and stale: bytes without use.
    std::size_t written = 0;             ///< Bytes of the reply in `out`.
};

/// A state that is due and that no record can carry, since the application gave it a value out of range.
struct unsendable_state {
    order_type type = order_type::none;  ///< cart_state or circuit_state; `none`: all that is due can be sent.
    std::uint32_t cart_id = 0;           ///< Of a cart_state.
    error fault{};                       ///< `out_of_range`, with the first field at fault.

    constexpr explicit operator bool() const noexcept { return type != order_type::none; }
};

namespace detail {

/// Why a state cannot be sent, whatever its number; no code when it can.
template <class M>
constexpr error fault_of(M state) noexcept {
    state.msg_id = 0;
    return is_valid(state) ? error{} : refusal(state);
}

}  // namespace detail

/// Lets every order pass that the slots can take.
struct accept_all {
    constexpr std::string_view operator()(const auto&, const cart*) const noexcept { return {}; }
};

}  // namespace trama::gateway
