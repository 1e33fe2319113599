#pragma once
// What the sessions share: a script, taken from the input, that says what happens next to state machines which talk to each other, and
// lines that lose and change what they carry.
#include <deque>
#include <utility>

#include "random_message.hpp"
#include "traits.hpp"

namespace trama::fuzz {

/// Bytes that have been sent and have not arrived.
struct byte_line {
    std::deque<std::uint8_t> under_way;

    void send(std::span<const std::uint8_t> bytes) { under_way.insert(under_way.end(), bytes.begin(), bytes.end()); }
    /// The first `n` of them, or all.
    octets take(std::size_t n) {
        const auto end = under_way.begin() + static_cast<std::ptrdiff_t>(std::min(n, under_way.size()));
        const octets piece(under_way.begin(), end);
        under_way.erase(under_way.begin(), end);
        return piece;
    }
    /// One byte changed, lost or doubled, or others put in. False when there was nothing to damage.
    bool damage(dice& d) {
        const std::size_t kind = d.below(4);
        const auto at = under_way.begin() + static_cast<std::ptrdiff_t>(d.below(under_way.size() + (kind == 3 ? 1 : 0)));
        if (kind == 3) {
            const std::size_t wanted = 1 + d.below(40);
            const std::size_t n = std::min(d.left().size(), wanted);
            octets foreign(n);
            for (auto& b : foreign) b = static_cast<std::uint8_t>(d.below(256));
            under_way.insert(at, foreign.begin(), foreign.end());
            return n != 0;
        }
        if (under_way.empty()) return false;
        if (kind == 0) *at = static_cast<std::uint8_t>(*at ^ 1U << d.below(8));
        else if (kind == 1) under_way.erase(at);
        else under_way.insert(at, *at);
        return true;
    }
};

/// At once, since a broken property ends the program.
template <class F>
void print_sent(std::span<const std::uint8_t> bytes) {
    traits<F>::print_wire(bytes);
    std::fflush(stdout);
}

/// Time goes on by `by`; now and then the clock is set back by as much instead.
inline void pass_time(std::uint64_t& now, std::uint64_t by, dice& d) { now = d.one_in(16) ? now - std::min(now, by) : now + by; }

/// Calls `step()` until the script is at its end, or long enough.
inline void play(const dice& script, auto&& step) {
    for (int steps = 0; steps != 500 && !script.left().empty(); ++steps) step();
}

/// Calls `step()` while it returns true; a machine that never has enough has hung.
inline void until_done(auto&& step, std::size_t most) {
    for (std::size_t calls = 0; step(); ++calls) require(calls != most, "a state machine comes to an end with what it is given");
}

}  // namespace trama::fuzz
