#pragma once
// Random choices that follow from a seed alone, on every machine.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trama::test {

using octets = std::vector<std::uint8_t>;

inline octets repeated(const octets& one, std::size_t times) {
    octets all;
    for (; times != 0; --times) all.insert(all.end(), one.begin(), one.end());
    return all;
}

/// A splitmix64 generator.
class rng {
public:
    explicit rng(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15 + 0x632BE59BD9B4E019) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9;
        z = (z ^ z >> 27) * 0x94D049BB133111EB;
        return z ^ z >> 31;
    }
    /// 0..n-1; n at least 1.
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
    /// low..high.
    std::size_t within(std::size_t low, std::size_t high) { return low + below(high - low + 1); }
    bool one_in(std::size_t n) { return below(n) == 0; }
    std::uint8_t byte() { return static_cast<std::uint8_t>(next()); }
    template <class T>
    const T& pick(std::span<const T> all) { return all[below(all.size())]; }
    template <class T>
    const T& pick(const std::vector<T>& all) { return all[below(all.size())]; }

    octets bytes(std::size_t n) {
        octets all(n);
        for (auto& b : all) b = byte();
        return all;
    }

private:
    std::uint64_t state_;
};

}  // namespace trama::test
