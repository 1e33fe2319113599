#pragma once
#include <cstdint>

namespace trama::bench {

/// Repeatable randomness (splitmix64): the same streams everywhere.
class dice {
public:
    explicit dice(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9;
        z = (z ^ z >> 27) * 0x94D049BB133111EB;
        return z ^ z >> 31;
    }
    /// 0..n-1.
    std::uint64_t below(std::uint64_t n) { return (next() >> 32) * n >> 32; }
    bool one_in(std::uint64_t n) { return below(n) == 0; }

private:
    std::uint64_t state_;
};

}  // namespace trama::bench
