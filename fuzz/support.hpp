#pragma once
// What every target needs: a loud end for a broken property, exact-size copies, and choices drawn from bytes.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

namespace trama::fuzz {

using octets = std::vector<std::uint8_t>;

/// A state that must be impossible ends the program, so that an engine keeps the input.
inline void require(bool held, const char* property) {
    if (held) [[likely]] return;
    std::fprintf(stderr, "property broken: %s\n", property);
    std::abort();
}

/// A copy in a heap block of exactly its size: AddressSanitizer then sees the first element read beyond it.
template <class T>
class exact {
public:
    explicit exact(std::span<const T> from) : size_(from.size()), block_(std::make_unique<T[]>(from.size())) {
        for (std::size_t i = 0; i != size_; ++i) block_[i] = from[i];
    }
    explicit exact(std::size_t size) : size_(size), block_(std::make_unique<T[]>(size)) {}
    std::span<T> all() { return {block_.get(), size_}; }
    std::span<const T> all() const { return {block_.get(), size_}; }

private:
    std::size_t size_;
    std::unique_ptr<T[]> block_;
};

/// A number that follows from the content alone, so that a target is deterministic.
inline std::uint32_t hash_of(std::span<const std::uint8_t> bytes) {
    std::uint32_t h = 2166136261U;
    for (const std::uint8_t b : bytes) h = (h ^ b) * 16777619U;
    return h;
}

/// Choices: first from the bytes given, where a fuzzer can steer them, then from a generator seeded by `seed`.
class dice {
public:
    explicit dice(std::uint32_t seed, std::span<const std::uint8_t> bytes = {}) : bytes_(bytes), state_(seed * 2654435761U + 1) {}

    std::uint32_t next() {
        state_ = state_ * 1664525U + 1013904223U;
        std::uint32_t v = state_ >> 16 | state_ << 16;
        if (!bytes_.empty()) {
            v = 0;
            for (std::size_t i = 0; i != 4 && !bytes_.empty(); ++i, bytes_ = bytes_.subspan(1)) v = v << 8 | bytes_[0];
        }
        return v;
    }
    /// 0..n-1, from one byte where that is enough.
    std::size_t below(std::size_t n) {
        if (n <= 1) return 0;
        if (n <= 256 && !bytes_.empty()) {
            const std::uint8_t b = bytes_[0];
            bytes_ = bytes_.subspan(1);
            return b % n;
        }
        return next() % n;
    }
    bool one_in(std::size_t n) { return below(n) == 0; }
    std::span<const std::uint8_t> left() const { return bytes_; }

private:
    std::span<const std::uint8_t> bytes_;
    std::uint32_t state_;
};

}  // namespace trama::fuzz
