#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>

#include "trama/core/bytes.hpp"
#include "trama/core/text.hpp"

/// Wire types: stateless descriptions of how one value lies on the wire. Each has `size` in bytes, `type_name`
/// for the documentation, `load(p, out)` returning nonzero on malformed bytes, `carries(v)` saying whether the
/// bytes can express `v`, and `store(p, v)` for those they can.
namespace trama::wire {

/// How a value is printed.
enum class print : std::uint8_t { number, tenths, text, hex };

/// Two's-complement or unsigned integer, least significant byte first. [daisy §11]
template <std::integral T>
struct le {
    using value = T;
    static constexpr std::size_t size = sizeof(T);
    static constexpr print printed = print::number;
    static constexpr std::int64_t low = std::numeric_limits<T>::min(), high = std::numeric_limits<T>::max();
    static constexpr std::string_view type_name = std::is_signed_v<T> ? (size == 2 ? "i16" : "i32") : size == 1 ? "u8" : "u16";

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept {
        out = static_cast<value>(load_le<std::make_unsigned_t<T>>(p));
        return 0;
    }
    static constexpr void store(std::uint8_t* p, value v) noexcept { store_le(p, static_cast<std::make_unsigned_t<T>>(v)); }
};
using u8 = le<std::uint8_t>;
using u16 = le<std::uint16_t>;
using i16 = le<std::int16_t>;
using i32 = le<std::int32_t>;

/// Year as two bytes, century then year: 20, 11 is 2011; a byte above 99 is malformed. [can §1]
struct century_year {
    using value = std::uint16_t;
    static constexpr std::size_t size = 2;
    static constexpr print printed = print::number;
    static constexpr std::int64_t low = 0, high = 9999;
    static constexpr std::string_view type_name = "century, year";

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept {
        out = static_cast<value>(p[0] * 100 + p[1]);
        return p[0] > 99 || p[1] > 99 ? 1U : 0U;
    }
    static constexpr void store(std::uint8_t* p, value v) noexcept {
        p[0] = static_cast<std::uint8_t>(v / 100);
        p[1] = static_cast<std::uint8_t>(v % 100);
    }
};

/// Two letters; their value is the first × 256 + the second. [can §1]
struct letter_pair {
    using value = std::uint16_t;
    static constexpr std::size_t size = 2;
    static constexpr print printed = print::number;
    static constexpr std::int64_t low = 0, high = 0xFFFF;
    static constexpr std::string_view type_name = "2 letters";

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept {
        out = static_cast<value>(p[0] << 8 | p[1]);
        return 0;
    }
    static constexpr void store(std::uint8_t* p, value v) noexcept {
        p[0] = static_cast<std::uint8_t>(v >> 8);
        p[1] = static_cast<std::uint8_t>(v);
    }
};

/// A value and, behind it, a byte that is always the same and needs no member.
template <class W, char Constant>
struct followed_by : W {
    static constexpr std::size_t size = W::size + 1;
    static constexpr char constant = Constant;

    static constexpr void store(std::uint8_t* p, typename W::value v) noexcept {
        W::store(p, v);
        p[W::size] = static_cast<std::uint8_t>(Constant);
    }
};

/// `Count` values of one wire type, one after the other.
template <class Element, std::size_t Count>
struct repeated {
    using element = Element;
    static constexpr std::size_t size = Element::size * Count, count = Count, max_count = Count;
    static constexpr print printed = Element::printed;
    static constexpr std::string_view type_name = Element::type_name;
};

/// A structure that has a layout of its own.
template <class T>
struct record {
    using value = T;
    static constexpr std::size_t size = T::layout.size;
    static constexpr std::string_view type_name = "structure";
};

/// A structure that the document tears apart: of its bytes, those from `Split` on lie `Gap` bytes further on.
/// `Size` is what the structure adds to the offset of the next field.
template <class T, std::size_t Split, std::size_t Gap, std::size_t Size>
struct torn_record {
    using value = T;
    static constexpr std::size_t size = Size;
    static constexpr std::string_view type_name = "structure";

    static constexpr std::size_t first_piece = Split;
    static constexpr std::size_t at(std::size_t i) noexcept { return i < Split ? i : i + Gap; }
    static constexpr auto gather(const std::uint8_t* p) noexcept {
        std::array<std::uint8_t, T::layout.size> whole{};
        for (std::size_t i = 0; i != whole.size(); ++i) whole[i] = p[at(i)];
        return whole;
    }
    static constexpr void scatter(std::uint8_t* p, const std::array<std::uint8_t, T::layout.size>& whole) noexcept {
        for (std::size_t i = 0; i != whole.size(); ++i) p[at(i)] = whole[i];
    }
};

/// As many bytes as remain when `Keep` more bytes follow; at least `Min`, in all at most `Max`.
template <print Printed, std::size_t Keep, std::size_t Min, std::size_t Max>
struct rest {
    using value = byte_view;
    static constexpr std::size_t size = 0, keep = Keep, min = Min, max_size = Max;
    static constexpr print printed = Printed;
    static constexpr std::string_view type_name = Printed == print::text ? "text" : "bytes";

    static constexpr bool carries(const value& v) noexcept { return v.size() >= Min && v.size() <= Max; }
    static constexpr std::size_t length(const value& v) noexcept { return v.size(); }
    static constexpr std::uint64_t load(const std::uint8_t* p, std::size_t n, value& out) noexcept {
        out = byte_view({p, n});
        return 0;
    }
    /// `v` may lie where it is written to.
    static constexpr void store(std::uint8_t* p, const value& v) noexcept {
        if (std::is_constant_evaluated()) {
            std::array<std::uint8_t, Max> copy{};
            for (std::size_t i = 0; i != v.size(); ++i) copy[i] = v[i];
            copy_bytes(p, copy.data(), v.size());
        } else if (!v.empty()) {
            std::memmove(p, v.bytes().data(), v.size());
        }
    }
};

/// As many values as the message's `expected_count()` says. Like `rest`, its length is no constant.
template <class Element, std::size_t Capacity>
struct counted {
    using value = bounded_list<typename Element::value, Capacity>;
    using element = Element;
    static constexpr std::size_t size = 0, max_size = Element::size * Capacity, max_count = Capacity;
    static constexpr print printed = Element::printed;
    static constexpr std::string_view type_name = Element::type_name;

    static constexpr std::size_t length(const value& v) noexcept { return v.size() * Element::size; }
    static constexpr std::uint64_t load(const std::uint8_t* p, std::size_t n, value& out) noexcept {
        out = {};
        for (std::size_t at = 0; at + Element::size <= n; at += Element::size) {
            typename Element::value one{};
            (void)Element::load(p + at, one);
            (void)out.push_back(one);
        }
        return 0;
    }
    static constexpr void store(std::uint8_t* p, const value& v) noexcept {
        for (std::size_t i = 0; i != v.size(); ++i) Element::store(p + i * Element::size, v[i]);
    }
};

/// A wire type whose length is not a constant.
template <class W>
concept variable = requires { W::max_size; };

}  // namespace trama::wire
