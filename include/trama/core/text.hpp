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

/// What a `bounded_list` keeps, and its constructors: one for each number of values up to that of `Places`. The parameters are
/// of type T itself, so that a value in braces that does not fit is refused like that of any other field.
template <class T, std::size_t Capacity, class Places = std::make_index_sequence<Capacity>>
struct list_content;
template <class T, std::size_t Capacity>
struct list_content<T, Capacity, std::index_sequence<>> {
    std::array<T, Capacity> values{};
    std::uint8_t count = 0;  ///< 0..Capacity.
};
template <class T, std::size_t Capacity, std::size_t... Places>
struct list_content<T, Capacity, std::index_sequence<Places...>> : list_content<T, Capacity, std::make_index_sequence<sizeof...(Places) - 1>> {
    template <std::size_t>
    using value_at = T;

    using list_content<T, Capacity, std::make_index_sequence<sizeof...(Places) - 1>>::list_content;
    constexpr list_content() = default;
    constexpr list_content(value_at<Places>... all) noexcept {
        this->values = {all...};
        this->count = sizeof...(Places);
    }
};

/// Up to `Capacity` values in place. Compares those before `size()`.
template <class T, std::size_t Capacity>
struct bounded_list : list_content<T, Capacity> {
    using list_content<T, Capacity>::values, list_content<T, Capacity>::count;

    constexpr bounded_list() = default;
    /// The values given, as in `{1, 2, 3}`; more than `Capacity` do not compile.
    using list_content<T, Capacity>::list_content;

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
};

}  // namespace trama
