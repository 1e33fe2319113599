#pragma once
// The ring itself: pseudo-terminals from each member to the next, and the faults on them.

#include <poll.h>
#include <pty.h>
#include <termios.h>

#include "common/faults.hpp"

namespace robot {

using namespace example;

/// A pseudo-terminal that carries bytes one way: what is written to `in` comes out of `out`.
struct line {
    int in = -1, out = -1;

    void open() {
        termios raw{};
        cfmakeraw(&raw);
        raw.c_cc[VMIN] = 1;
        if (openpty(&in, &out, nullptr, &raw, nullptr) != 0) die("openpty");
        unblock(in);
        unblock(out);
    }
};

/// One member's two ends: reads from the line before it, writes to the one behind it, with damage on the way.
class ends {
public:
    ends(const line& before, const line& behind, const odds& o, unsigned long seed, const std::string& record)
        : from_(before.out), to_(behind.in), fate_(o, seed), record_(record) {}

    /// What has come, after at most `patience` milliseconds.
    octets wait(int patience) {
        pollfd ready[2] = {{from_, POLLIN, 0}, {to_, static_cast<short>(out_.empty() ? 0 : POLLOUT), 0}};
        poll(ready, 2, patience);
        if (now() >= held_until_) out_.flush(to_);
        std::uint8_t in[512];
        const ssize_t n = read(from_, in, sizeof in);
        return n > 0 ? octets(in, in + n) : octets{};
    }
    void send(std::span<const std::uint8_t> packet) {
        if (packet.empty()) return;
        octets sent;
        for (std::uint8_t b : packet) {
            if (fate_.drops()) continue;
            if (fate_.doubles()) sent.push_back(b);
            if (fate_.flips()) b ^= fate_.one_bit();
            sent.push_back(b);
        }
        record_.write(sent);
        out_.add(sent);
        if (fate_.delays()) held_until_ = now() + 30;
        if (now() >= held_until_) out_.flush(to_);
    }
    std::uint64_t faults() const { return fate_.count(); }

private:
    int from_, to_;
    fate fate_;
    capture record_;
    outbox out_;
    std::uint64_t held_until_ = 0;
};

}  // namespace robot
