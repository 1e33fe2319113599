#pragma once
// Damage on purpose: how often, and when.

#include <random>

#include "common/process.hpp"

namespace example {

/// Odds of damage: one in so many bytes or frames; 0 is never.
struct odds {
    unsigned long flip = 0, drop = 0, duplicate = 0, delay = 0;

    bool any() const { return (flip | drop | duplicate | delay) != 0; }
    static void add_to(options& o, const std::string& unit) {
        o.add("flip", "N", "flip a bit in one of N " + unit, "0");
        o.add("drop", "N", "lose one of N " + unit, "0");
        o.add("duplicate", "N", "double one of N " + unit, "0");
        o.add("delay", "N", "hold one of N pieces up for 30 ms", "0");
        o.add("seed", "N", "start of the random numbers for all that", "1");
    }
    static odds of(const options& o) { return {o.number("flip"), o.number("drop"), o.number("duplicate"), o.number("delay")}; }
};

/// Decides what happens to the next unit.
class fate {
public:
    fate(const odds& o, unsigned long seed) : odds_(o), random_(static_cast<std::mt19937::result_type>(seed)) {}

    bool flips() { return happens(odds_.flip); }
    bool drops() { return happens(odds_.drop); }
    bool doubles() { return happens(odds_.duplicate); }
    bool delays() { return happens(odds_.delay); }
    std::uint8_t one_bit() { return static_cast<std::uint8_t>(1U << random_() % 8); }
    std::uint64_t count() const { return count_; }

private:
    bool happens(unsigned long one_in) {
        const bool now = one_in != 0 && random_() % one_in == 0;
        count_ += now ? 1U : 0U;
        return now;
    }
    odds odds_;
    std::mt19937 random_;
    std::uint64_t count_ = 0;
};

}  // namespace example
