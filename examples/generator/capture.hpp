#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace traffic {

/// The same numbers on every machine, which the standard distributions do not promise.
class numbers {
public:
    explicit numbers(std::uint64_t seed) : state_(seed) {}

    /// A number in low..high.
    int between(int low, int high) {
        return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
    }

private:
    std::uint64_t next() {  // splitmix64
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9U;
        z = (z ^ z >> 27) * 0x94D049BB133111EBU;
        return z ^ z >> 31;
    }

    std::uint64_t state_;
};

/// Bytes as they went over a line, in order.
class capture {
public:
    capture& operator<<(std::string_view bytes) {
        bytes_ += bytes;
        return *this;
    }
    capture& operator<<(std::span<const std::uint8_t> bytes) {
        bytes_.append(bytes.begin(), bytes.end());
        return *this;
    }
    /// Bytes that nobody sent.
    void noise(numbers& random, int count) {
        for (; count > 0; --count) bytes_ += static_cast<char>(random.between(0, 255));
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// The serial line of a robot that starts, drives about and meets some trouble.
std::string robot();
/// A candump log of a greenhouse.
std::string greenhouse();
/// Both directions of a warehouse system's connection to the gateway of a circuit of carts.
std::string warehouse();

}  // namespace traffic
