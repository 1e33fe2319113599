#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "trama/core/error.hpp"

namespace trama {

/// What a document allows a value to be, and how that is printed.
/// A range prints as `low..high` or as the number if there is but one, a list of names as `a|b|c`, others as `words`.
struct rule {
    std::int64_t low = std::numeric_limits<std::int64_t>::min();
    std::int64_t high = std::numeric_limits<std::int64_t>::max();
    std::int64_t also = low;                    ///< One more value beside the range.
    std::uint64_t set = 0;                      ///< Not 0: only values v with bit v set, each below 64.
    std::span<const std::string_view> names{};  ///< Printed instead of the range.
    std::string_view words{};                   ///< Printed instead of the range.

    constexpr bool allows(std::int64_t v) const noexcept {
        if (set != 0) return v >= 0 && v < 64 && (set >> v & 1) != 0;
        return (low <= v && v <= high) || v == also;
    }
    /// True when the document says nothing about the value.
    constexpr bool any() const noexcept {
        return set == 0 && words.empty() && low == std::numeric_limits<std::int64_t>::min() && high == std::numeric_limits<std::int64_t>::max();
    }
};

/// Bounds, both included.
constexpr rule between(std::int64_t low, std::int64_t high) noexcept { return {low, high, low, 0, {}, {}}; }

/// A value that the document or the wire does not allow.
struct violation {
    field_ref field{};              ///< `print_path<M>` writes its name. Of a daisy packet's addresses `source` or `destination`, of can's identifier `id`.
    std::int64_t value = 0;         ///< As a number, whatever the field's type. Of a list or bytes their count; of a text its first character that is not printable, 0 if it is too long.
    const rule* allowed = nullptr;  ///< Lives as long as the program.
};

/// The violations of one message, at most one for each value: first lists of the wrong length and fields that should
/// not be there, then the values in field order.
template <std::size_t Capacity>
class violation_list {
public:
    constexpr void push_back(const violation& v) noexcept {
        if (count_ != Capacity) items_[count_++] = v;
    }
    constexpr std::size_t size() const noexcept { return count_; }
    constexpr bool empty() const noexcept { return count_ == 0; }
    constexpr const violation& operator[](std::size_t i) const noexcept { return items_[i]; }
    constexpr const violation* begin() const noexcept { return items_.data(); }
    constexpr const violation* end() const noexcept { return items_.data() + count_; }

private:
    std::array<violation, Capacity == 0 ? 1 : Capacity> items_{};
    std::size_t count_ = 0;
};

}  // namespace trama
