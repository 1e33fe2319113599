#pragma once

#include "trama/can/schedule.hpp"
#include "trama/can/transmit_queue.hpp"
#include "trama/core/link_quality.hpp"

namespace trama::can {

/// How patient a master is, in the caller's unit of time.
struct timing {
    std::uint64_t second = 1000;   ///< One second of the calendar in that unit, not 0.
    std::uint64_t poll = 1000;     ///< From one round of readings to the next, at least: one second. [can §2]
    std::uint64_t timeout = 200;   ///< From the last frame of a request to the moment when it is sent again.
    unsigned attempts = 4;         ///< How often a request is sent in all.
    std::uint64_t partial = 100;   ///< Age at which a partial message is given up; shorter than `timeout`.
};

/// What happened at a master.
enum class master_news : std::uint8_t {
    need_more,   ///< Nothing; call again with more frames or later.
    answered,    ///< The reply to a request, in `packet`: sensor_readings, actuator_state, or the echo of F, M or C.
    asks_again,  ///< No reply in time, or a wrong one: the request is sent once more.
    failed,      ///< No right reply after all attempts.
    clock,       ///< The central master has set everyone's clock; `master::clock()` goes by it.
    stray,       ///< A message that is no reply to the latest attempt of the request under way, such as a late reply; in `packet`.
    fault,       ///< Frames that make no message: `code`, `skipped`.
};

/// What `master::next` reports. Views live until the master's next call.
struct master_event {
    master_news news = master_news::need_more;
    can::packet packet{};          ///< Where a message came.
    std::uint8_t node = 0;         ///< Of the request that it is about.
    std::uint8_t message_id = 0;   ///< Likewise.
    char letter = 0;               ///< Likewise: F, R, A, M or C.
    unsigned attempt = 0;          ///< How often that request has been sent.
    bool wrong = false;            ///< Of asks_again and failed: the latest reply was a wrong one, not a missing one.
    errc code = errc::ok;          ///< Of fault.
    std::uint64_t skipped = 0;     ///< Of fault: frames without use.
};

/// Whether `M` is something that a master asks.
template <class M>
concept request_message = std::is_same_v<M, define_function> || std::is_same_v<M, read_sensors> || std::is_same_v<M, read_actuator> ||
                          std::is_same_v<M, set_actuator> || std::is_same_v<M, set_clock>;

/// A node whose sensors are read in every round.
struct polled_node {
    std::uint8_t node = 0;
    link_quality quality{};  ///< `bytes_…` and `goodput` count frames.
};

/// Those of one master.
template <std::size_t Nodes>
struct polled_nodes {
    std::size_t count = 0;
    std::array<polled_node, Nodes> all{};

    /// False when there is no place for it.
    constexpr bool add(std::uint8_t node) noexcept {
        if (find(node) != nullptr) return true;
        if (count == Nodes) return false;
        all[count++].node = node;
        return true;
    }
    /// Null when it is none of them.
    constexpr polled_node* find(std::uint8_t node) noexcept {
        for (std::size_t i = 0; i != count; ++i)
            if (all[i].node == node) return &all[i];
        return nullptr;
    }
    constexpr const polled_node* find(std::uint8_t node) const noexcept {
        for (std::size_t i = 0; i != count; ++i)
            if (all[i].node == node) return &all[i];
        return nullptr;
    }
};

/// A request as a master keeps it: the frames' data run together.
struct pending_request {
    std::uint8_t index = 0;     ///< Place in `messages`.
    std::uint8_t size = 0;
    unsigned attempts = 0;      ///< How often it was given to the queue.
    unsigned replies = 0;       ///< Right and wrong ones.
    bool poll = false;          ///< One of a round of polls.
    std::array<std::uint8_t, 8 * max_frames> octets{};

    template <request_message M>
    static constexpr pending_request of(const M& m) noexcept {
        pending_request r{};
        messages::each([&, i = std::uint8_t{0}]<class Other>() mutable {
            if constexpr (std::is_same_v<Other, M>) r.index = i;
            ++i;
        });
        r.size = M::layout.size;
        store_body(r.octets.data(), m);
        return r;
    }
    constexpr std::size_t frames() const noexcept { return known.shapes[index].frames; }
    /// Its `frames()` frames under identifier `id`.
    constexpr std::array<frame, max_frames> under(std::uint32_t id) const noexcept {
        std::array<frame, max_frames> out{};
        std::size_t at = 0;
        for (std::size_t i = 0; i != frames(); at += out[i++].length) {
            out[i].id = id;
            out[i].length = known.shapes[index].lengths[i];
            copy_bytes(out[i].data.data(), octets.data() + at, out[i].length);
        }
        return out;
    }

    constexpr std::uint8_t node() const noexcept { return octets[0]; }
    constexpr std::uint8_t message_id() const noexcept { return octets[1]; }
    constexpr char letter() const noexcept { return static_cast<char>(octets[2]); }
    /// Says in `e` that this is the request that it is about.
    constexpr void name_in(master_event& e) const noexcept {
        e.node = node();
        e.message_id = message_id();
        e.letter = letter();
        e.attempt = attempts;
    }
    /// True for a packet with the same node, number and letter: a reply, though it may be a wrong one.
    constexpr bool is_answered_by(const packet& p) const noexcept {
        const auto body = p.body();
        return body.size() >= min_first_length && body[0] == octets[0] && body[1] == octets[1] && body[2] == octets[2];
    }
    /// True for the right reply. It begins with the request's bytes: an echo is the same, the others go on behind them.
    constexpr bool is_rightly_answered_by(const packet& p) const noexcept {
        const auto body = p.body();
        const bool echo = letter() != 'R' && letter() != 'A';
        if (echo ? body.size() != size : body.size() <= size) return false;
        for (std::size_t i = 0; i != size; ++i)
            if (body[i] != octets[i]) return false;
        bool valid = false;
        (void)visit<format>(p, [&](const auto& m) { valid = is_valid(m); });
        return valid;
    }
};

/// Whether one of a round of polls is among them.
constexpr bool holds_poll(std::span<const pending_request> requests) noexcept {
    for (const pending_request& r : requests)
        if (r.poll) return true;
    return false;
}

}  // namespace trama::can
