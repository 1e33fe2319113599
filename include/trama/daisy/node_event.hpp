#pragma once

#include "trama/daisy/link_requests.hpp"

namespace trama::daisy {

/// What a board's handler says about a request: done, or the code of the `error` that answers it. [daisy §3.4]
/// Codes from 2 on belong to the board; this library uses 2 and 3.
enum class answer : std::uint8_t {
    done = 0,             ///< The reply is sent. As an error code, 0 would be a bad CRC.
    unknown_command = 1,
    out_of_range = 2,     ///< A value that the document does not allow.
    failed = 3,           ///< The handler's own reply cannot be sent.
};

/// What happened at a board.
enum class node_news : std::uint8_t {
    need_more,   ///< Nothing; call again with more bytes or later.
    no_room,     ///< `out` is smaller than `max_output`; nothing was consumed.
    executed,    ///< A request was carried out and answered.
    refused,     ///< A request was answered by `error`, whose code is `verdict`.
    passed_on,   ///< A packet for somebody else.
    removed,     ///< A packet that has gone round, or one that could never be taken off.
    confirmed,   ///< The main controller has received an alarm.
    sent_again,  ///< An alarm without a reply in time, or a packet that somebody reported as damaged.
    lost,        ///< An alarm was given up.
    told,        ///< An `error` or a reply that belongs to nothing in flight; in `packet`.
    fault,       ///< Damaged bytes: `code`, `skipped`. Answered by `error` 0 where that can help.
};

/// What `node::next` reports. Views live until the node's next call, and no longer than the chunk given to it.
struct node_event {
    node_news news = node_news::need_more;
    daisy::packet packet{};        ///< Where one came. For news about an alarm, its reply.
    answer verdict{};              ///< Of refused.
    errc code = errc::ok;          ///< Of fault.
    std::uint64_t skipped = 0;     ///< Of fault: bytes without use.
    std::size_t written = 0;       ///< Bytes in `out` to be sent to the next member.
};

}  // namespace trama::daisy
