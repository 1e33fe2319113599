#pragma once

#include "trama/core/link_quality.hpp"
#include "trama/daisy/format.hpp"

/// What every member of a ring needs: where packets go, when a line is silent, what to answer to a damaged packet.
namespace trama::daisy {

/// How patient a member is, in the caller's unit of time.
struct timing {
    std::uint64_t timeout = 200;  ///< From a request to the moment when it is sent again. Longer than a packet takes round the ring.
    unsigned attempts = 4;        ///< How often a request is sent in all.
    std::uint64_t idle = 50;      ///< Silence, from the first call on, that ends a partial packet and shows where the next one begins; 0: never.
    std::uint64_t orphan = 0;     ///< Packets that come by twice within this time are taken off; 0: see `node` and `controller`.
};

/// Time gone by; 0 for clocks that go backwards.
constexpr std::uint64_t elapsed(std::uint64_t since, std::uint64_t now) noexcept { return now > since ? now - since : 0; }

/// What becomes of a packet that arrives. [daisy §2.2, §2.3]
enum class route : std::uint8_t {
    remove,               ///< It has gone round, or nobody could ever take it off: a source with id 15.
    consume,              ///< It is for this member.
    consume_and_pass_on,  ///< It is for this member among others.
    pass_on,              ///< It is for somebody else.
};
constexpr route route_of(envelope e, address self) noexcept {
    if (e.source == self || e.source.broadcast()) return route::remove;
    if (e.destination == self) return route::consume;
    const bool my_group = e.destination.broadcast() && e.destination.group() == self.group();
    return my_group || e.destination == everyone ? route::consume_and_pass_on : route::pass_on;
}

/// Packets one behind the other in the caller's memory.
class packet_writer {
public:
    constexpr explicit packet_writer(std::span<std::uint8_t> out) noexcept : out_(out) {}

    /// The packet's bytes, empty when it was refused.
    template <has_layout M>
    constexpr std::span<const std::uint8_t> put(const envelope& e, const M& m) noexcept {
        const std::size_t n = format::encode(e, m, out_.subspan(size_)).value_or(0);
        size_ += n;
        packets_ += n != 0 ? 1U : 0U;
        return out_.subspan(size_ - n, n);
    }
    /// Precondition: there is room.
    constexpr void copy(std::span<const std::uint8_t> packet) noexcept {
        copy_bytes(out_.data() + size_, packet.data(), packet.size());
        size_ += packet.size();
        ++packets_;
    }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr std::size_t packets() const noexcept { return packets_; }

private:
    std::span<std::uint8_t> out_;
    std::size_t size_ = 0, packets_ = 0;
};

inline constexpr std::uint8_t bad_crc_code = 0;          ///< Code of an `error`. [daisy §3.4]
inline constexpr std::uint8_t unknown_command_code = 1;  ///< Code of an `error`. [daisy §3.4]

/// Whether a damaged packet is answered by `error` 0: not one that is too long for it [D5], nor an `error` (errors about
/// errors would breed), nor when the source could not be anybody.
constexpr bool deserves_error(std::span<const std::uint8_t> rejected, address self) noexcept {
    if (rejected.size() < min_packet || rejected.size() > 249) return false;
    const address source{rejected[2]};
    return source != self && !source.broadcast() && family_of(source.group()) != family::none && rejected[3] != command_of(common::error::key);
}

/// In how many bytes two packets of one size differ.
constexpr std::size_t differing(std::span<const std::uint8_t> sent, std::span<const std::uint8_t> rejected) noexcept {
    std::size_t n = 0;
    for (std::size_t i = 0; i != sent.size(); ++i) n += sent[i] != rejected[i] ? 1U : 0U;
    return n;
}
/// Whether `rejected`, as somebody received it, can be `sent` with some damage: as long, and at least half of it the same.
constexpr bool resembles(std::span<const std::uint8_t> sent, std::span<const std::uint8_t> rejected) noexcept {
    return sent.size() == rejected.size() && !sent.empty() && 2 * differing(sent, rejected) <= sent.size();
}

/// The receiving end of a line: a decoder that takes silence for the end of a packet.
class receiver {
public:
    constexpr explicit receiver(std::uint64_t idle) noexcept : idle_(idle) {}

    constexpr event next(std::span<const std::uint8_t>& in, std::uint64_t now, link_quality& line) noexcept {
        const bool silent = listens_ && idle_ != 0 && elapsed(last_, now) > idle_;
        if (silent) decoder_.idle();  // also with nothing pending: what comes next begins a packet
        if (!in.empty() || silent || !listens_) last_ = now;
        listens_ = true;
        const event e = decoder_.next(in);
        if (e.code == errc::ok || e.code == errc::unknown_message) line.received(e.length, now);
        else if (e.code != errc::need_more) line.lost_step(e.length);
        return e;
    }

private:
    std::uint64_t idle_;
    std::uint64_t last_ = 0;  ///< When the latest bytes came, or the first call.
    bool listens_ = false;    ///< It was called: what was before is unknown, be it silence or half a packet.
    decoder decoder_{};
};

/// 32 bits by which packets are told apart: FNV-1a.
constexpr std::uint32_t fingerprint(std::span<const std::uint8_t> packet) noexcept {
    std::uint32_t print = 2166136261U;
    for (const std::uint8_t b : packet) print = (print ^ b) * 16777619U;
    return print;
}

/// Remembers the packets that passed by of late, as 32-bit fingerprints, to tell those that go round and round: a
/// packet whose source is not on the ring is taken off by nobody, and no byte of it counts its rounds.
template <std::size_t Size>
class orphan_filter {
public:
    constexpr explicit orphan_filter(std::uint64_t period) noexcept : period_(period) {}

    /// What was found out about a packet; `fresh` and `full` ones are remembered from now on.
    enum class verdict : std::uint8_t {
        fresh,     ///< Not seen within the period.
        repeated,  ///< Seen within the period.
        full,      ///< Not seen, but the oldest of the others had to be forgotten before its time.
    };
    constexpr verdict judge(std::span<const std::uint8_t> packet, std::uint64_t now) noexcept {
        const std::uint32_t print = fingerprint(packet);
        entry* oldest = &entries_[0];
        for (entry& e : entries_) {
            if (is_recent(e, now) && e.print == print) return verdict::repeated;
            if (!e.used || (oldest->used && e.time < oldest->time)) oldest = &e;
        }
        const bool lost = is_recent(*oldest, now);
        *oldest = {now, print, true};
        return lost ? verdict::full : verdict::fresh;
    }

private:
    struct entry {
        std::uint64_t time = 0;
        std::uint32_t print = 0;
        bool used = false;
    };
    constexpr bool is_recent(const entry& e, std::uint64_t now) const noexcept { return e.used && elapsed(e.time, now) <= period_; }

    std::uint64_t period_;
    std::array<entry, Size> entries_{};
};

}  // namespace trama::daisy
