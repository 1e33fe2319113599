#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "trama/core/bytes.hpp"

namespace trama {

/// Two pieces of memory read as one: what a decoder kept of earlier chunks, then the chunk it was given.
class window {
public:
    constexpr window(std::span<const std::uint8_t> first, std::span<const std::uint8_t> second) noexcept : first_(first), second_(second) {}

    constexpr std::size_t size() const noexcept { return first_.size() + second_.size(); }
    constexpr std::uint8_t operator[](std::size_t i) const noexcept { return i < first_.size() ? first_[i] : second_[i - first_.size()]; }
    /// The bytes from `at` on that lie in one piece. Precondition: `at` is below `size()`.
    constexpr std::span<const std::uint8_t> run(std::size_t at) const noexcept {
        return at < first_.size() ? first_.subspan(at) : second_.subspan(at - first_.size());
    }
    /// Exclusive or of `n` bytes from `at` on.
    constexpr std::uint8_t xor_of(std::size_t at, std::size_t n) const noexcept {
        const std::size_t here = at < first_.size() ? std::min(n, first_.size() - at) : 0;
        const std::size_t there = at < first_.size() ? 0 : at - first_.size();
        const std::uint8_t head = here != 0 ? trama::xor_of(first_.subspan(at, here)) : std::uint8_t{0};
        return static_cast<std::uint8_t>(head ^ trama::xor_of(second_.subspan(there, n - here)));
    }
    /// `n` bytes from `at` on in one piece, copied to `spare` only if they lie in both.
    constexpr std::span<const std::uint8_t> piece(std::size_t at, std::size_t n, std::span<std::uint8_t> spare) const noexcept {
        if (at + n <= first_.size()) return first_.subspan(at, n);
        if (at >= first_.size()) return second_.subspan(at - first_.size(), n);
        const std::size_t here = first_.size() - at;
        copy_bytes(spare.data(), first_.data() + at, here);
        copy_bytes(spare.data() + here, second_.data(), n - here);
        return spare.first(n);
    }

private:
    std::span<const std::uint8_t> first_, second_;
};

}  // namespace trama
