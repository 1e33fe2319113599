#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "trama/core/ascii.hpp"

namespace trama {

/// Fixed-width text as the wire carries it: `Columns` characters, the padding included.
/// Its value is the padded characters, so "A" and "A " are equal.
template <std::size_t Columns>
struct text {
    std::array<char, Columns> columns = blank();

    constexpr text() = default;
    /// Left-aligned copy of a literal, a std::string or whatever else is a std::string_view. What is longer than the field
    /// is marked by a first character NUL, and refused by both encoders.
    template <class S>
        requires(std::is_convertible_v<const S&, std::string_view>)
    constexpr text(const S& characters) noexcept {
        const std::string_view s = characters;
        for (std::size_t i = 0; i != s.size() && i != Columns; ++i) columns[i] = s[i];
        if (s.size() > Columns) columns[0] = '\0';
    }

    /// The text without the spaces that pad it on the right. Lives as long as this object.
    constexpr std::string_view view() const& noexcept {
        std::size_t n = Columns;
        while (n != 0 && columns[n - 1] == ' ') --n;
        return {columns.data(), n};
    }
    std::string_view view() const&& = delete;
    /// True when what was to be kept here was longer than the field.
    constexpr bool too_long() const noexcept { return columns[0] == '\0'; }
    /// False when a delimiter or another control character hides inside.
    constexpr bool printable() const noexcept {
        if constexpr (Columns >= 8 && Columns <= 16)
            if (!std::is_constant_evaluated()) return few_printable_vector<Columns>(columns.data());
        bool all = true;
        for (const char c : columns) all &= c >= 0x20 && c <= 0x7E;
        return all;
    }
    friend constexpr bool operator==(const text&, const text&) = default;

private:
    static constexpr std::array<char, Columns> blank() noexcept {
        std::array<char, Columns> all{};
        for (char& c : all) c = ' ';
        return all;
    }
};

/// Bytes that lie somewhere else: in the packet that a message was decoded from, or in memory that the
/// caller keeps. Compares by content. Lives as long as what it points into.
class byte_view {
public:
    constexpr byte_view() = default;
    constexpr byte_view(std::span<const std::uint8_t> bytes) noexcept : data_(bytes.data()), size_(bytes.size()) {}

    constexpr std::span<const std::uint8_t> bytes() const noexcept { return {data_, size_}; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr std::uint8_t operator[](std::size_t i) const noexcept { return data_[i]; }
    friend constexpr bool operator==(byte_view a, byte_view b) noexcept {
        if (a.size_ != b.size_) return false;
        for (std::size_t i = 0; i != a.size_; ++i)
            if (a.data_[i] != b.data_[i]) return false;
        return true;
    }

private:
    const std::uint8_t* data_ = nullptr;
    std::size_t size_ = 0;
};

/// Up to `Capacity` values in place. Compares those before `size()`.
template <class T, std::size_t Capacity>
struct bounded_list {
    std::array<T, Capacity> values{};
    std::uint8_t count = 0;  ///< 0..Capacity.

    constexpr bounded_list() = default;
    /// The values given; more than `Capacity` do not compile.
    template <class... U>
        requires(sizeof...(U) >= 1 && sizeof...(U) <= Capacity && (std::is_same_v<U, T> && ...))
    constexpr bounded_list(U... all) noexcept : values{all...}, count{sizeof...(U)} {}
    /// Constants, of whatever type; one that is no `T` does not compile. A variable has to be a `T`.
    template <class... U>
        requires(sizeof...(U) >= 1 && sizeof...(U) <= Capacity && (std::is_integral_v<U> && ...) && !(std::is_same_v<U, T> && ...))
    consteval bounded_list(U... all) : values{checked(all)...}, count{sizeof...(U)} {}

    constexpr std::size_t size() const noexcept { return count < Capacity ? count : Capacity; }
    constexpr const T& operator[](std::size_t i) const noexcept { return values[i]; }
    constexpr T& operator[](std::size_t i) noexcept { return values[i]; }
    constexpr const T* begin() const noexcept { return values.data(); }
    constexpr const T* end() const noexcept { return values.data() + size(); }
    /// Appends `v`; false when the list is full.
    constexpr bool push_back(T v) noexcept {
        if (count >= Capacity) return false;
        values[count++] = v;
        return true;
    }
    constexpr void clear() noexcept { *this = {}; }
    friend constexpr bool operator==(const bounded_list& a, const bounded_list& b) noexcept {
        if (a.size() != b.size()) return false;
        for (std::size_t i = 0; i != a.size(); ++i)
            if (a.values[i] != b.values[i]) return false;
        return true;
    }

private:
    template <class U>
    static consteval T checked(U v) {
        if (!std::in_range<T>(v)) the_value_does_not_fit();
        return static_cast<T>(v);
    }
    static void the_value_does_not_fit();  ///< Has no definition: to call it ends the compilation.
};

}  // namespace trama
