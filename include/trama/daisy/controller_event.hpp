#pragma once

#include "trama/daisy/link_requests.hpp"

namespace trama::daisy {

/// What happened at the main controller.
enum class controller_news : std::uint8_t {
    need_more,   ///< Nothing; call again with more bytes or later.
    no_room,     ///< `out` is smaller than `max_output`; nothing was consumed.
    reply,       ///< The reply to a request, or one of the replies to a broadcast; in `packet`.
    board,       ///< Likewise, to `init` or `reset`, by a board that was not in the list before.
    refused,     ///< `peer` sent an `error` with a code from 1 on, in `packet`; the oldest request to it that can be meant, `command`, is taken for the refused one.
    complete,    ///< A broadcast has gone round and everyone in the list whom it reaches has answered it, be it by an `error`; the list holds as many
                 ///< boards as `initialise` expected. In `packet` the call, if it has come home just now.
    absent,      ///< A request has gone round: no board has its address.
    failed,      ///< No reply after all attempts; of a broadcast: not from everyone.
    sent_again,  ///< A request without a reply in time, or one that somebody reported as damaged.
    alarm,       ///< An alarm of a board, acknowledged; in `packet`.
    told,        ///< An `error` or a reply that belongs to nothing in flight, such as a second reply, or a `ping`, which was answered; in `packet`.
    refusal,     ///< A request to the controller that is no alarm was answered by `error` 1.
    passed_on,   ///< A packet between two boards.
    removed,     ///< A packet that has gone round, an orphan, or one between boards whose source is not in the list or that memory has no room for.
    fault,       ///< Damaged bytes: `code`, `skipped`. Answered by `error` 0 where that can help.
};

/// What `controller::next` reports. Views live until the controller's next call, and no longer than the chunk given to it.
struct controller_event {
    controller_news news = controller_news::need_more;
    daisy::packet packet{};        ///< Where one came.
    address peer{};                ///< Who it is about: the sender, or the addressee of a request without reply.
    std::uint8_t command = 0;      ///< Of the request that it is about, where there is one.
    unsigned attempt = 0;          ///< How often that request has been sent.
    bool again = false;            ///< Of alarm: the board's latest by this command was the same, within the time of all attempts; its reply seems to be lost.
    errc code = errc::ok;          ///< Of fault.
    std::uint64_t skipped = 0;     ///< Of fault: bytes without use.
    std::size_t written = 0;       ///< Bytes in `out` to be sent to the next member.
};

/// A board that has answered `init` or `reset`.
struct board_info {
    static constexpr std::size_t max_description = 48;

    address where{};
    link_quality quality{};

    /// As the board describes itself, cut to `max_description`.
    constexpr std::span<const std::uint8_t> description() const noexcept { return {octets_.data(), size_}; }
    constexpr void describe(std::span<const std::uint8_t> text) noexcept {
        size_ = std::min(text.size(), max_description);
        copy_bytes(octets_.data(), text.data(), size_);
    }

private:
    std::size_t size_ = 0;
    std::array<std::uint8_t, max_description> octets_{};
};

/// The boards of the ring, in the order in which they answered first.
template <std::size_t Size>
class board_list {
public:
    static_assert(Size <= 64, "request_in_flight has one bit for each board");

    constexpr board_info* find(address a) noexcept {
        const std::size_t at = index_of_board(a);
        return at == count_ ? nullptr : &boards_[at];
    }
    /// Null when the list is full.
    constexpr board_info* add(address a) noexcept {
        if (count_ == Size) return nullptr;
        boards_[count_].where = a;
        return &boards_[count_++];
    }
    /// `size()` when it is not in the list.
    constexpr std::size_t index_of_board(address a) const noexcept {
        std::size_t i = 0;
        while (i != count_ && boards_[i].where != a) ++i;
        return i;
    }
    /// The bit by which it stands in `request_in_flight::answered`; none when it is not in the list.
    constexpr std::uint64_t bit_of(address a) const noexcept {
        const std::size_t at = index_of_board(a);
        return at == count_ ? 0 : std::uint64_t{1} << at;
    }
    constexpr void clear() noexcept { *this = board_list{}; }
    constexpr std::size_t size() const noexcept { return count_; }
    constexpr const board_info& operator[](std::size_t i) const noexcept { return boards_[i]; }
    constexpr const board_info* begin() const noexcept { return boards_.data(); }
    constexpr const board_info* end() const noexcept { return boards_.data() + count_; }
    /// One bit for each board that a packet to `to` reaches.
    constexpr std::uint64_t reached_by(address to) const noexcept {
        std::uint64_t all = 0;
        for (std::size_t i = 0; i != count_; ++i)
            if (reaches(to, boards_[i].where)) all |= std::uint64_t{1} << i;
        return all;
    }

private:
    std::array<board_info, Size> boards_{};
    std::size_t count_ = 0;
};

/// The latest alarm of each board by each command. A board sends a new one only when the one before is confirmed or
/// lost, so that a repeated one is always the latest; the same one after another is new, such as a switch's second edge.
template <std::size_t Size>
class alarm_memory {
public:
    constexpr explicit alarm_memory(std::uint64_t period) noexcept : period_(period) {}

    /// True when `p` is the latest one, and that came first within the period. Else it is the latest from now on.
    constexpr bool repeated(const packet& p, std::uint64_t now) noexcept {
        const entry latest{now, fingerprint(p.bytes()), p.envelope().source, p.command(), true};
        entry* place = &entries_[0];
        for (entry& e : entries_) {
            const bool same = e.used && e.source == latest.source && e.command == latest.command;
            if (same && e.print == latest.print && elapsed(e.time, now) <= period_) return true;
            if (same) {
                place = &e;
                break;
            }
            if (!e.used || (place->used && e.time < place->time)) place = &e;
        }
        *place = latest;
        return false;
    }

private:
    struct entry {
        std::uint64_t time = 0;
        std::uint32_t print = 0;
        address source{};
        std::uint8_t command = 0;
        bool used = false;
    };
    std::uint64_t period_;
    std::array<entry, Size> entries_{};
};

/// Whether `M` is what a board reports unasked. [daisy §6.10, §6.11, §7.13, §8.8, §9.4, §9.6, §10.2]
template <class M>
concept alarm_message = std::is_same_v<M, dc_motor::motor_stress_alarm> || std::is_same_v<M, dc_motor::motor_shut_down_alarm> ||
                        std::is_same_v<M, servo_motor::switch_alarm> || std::is_same_v<M, distance_sensor::switch_alarm> ||
                        std::is_same_v<M, battery_controller::battery_full_alarm> || std::is_same_v<M, battery_controller::battery_empty_alarm> ||
                        std::is_same_v<M, trash_bin::bin_full_alarm>;

}  // namespace trama::daisy
