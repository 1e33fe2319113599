#pragma once

#include "trama/core/column_map.hpp"
#include "trama/core/wire.hpp"

/// Wire types of fixed-width ASCII records. `decimal` marks those that an encoder may justify.
namespace trama::wire {

/// Unsigned decimal in `Columns` ASCII columns; blank is zero. [gateway, "Tipos de mensajes"; D15]
template <std::size_t Columns>
struct dec {
    using value = std::uint32_t;
    static constexpr std::size_t size = Columns;
    static constexpr print printed = print::number;
    static constexpr bool decimal = true;
    static constexpr std::int64_t low = 0, high = [] { std::int64_t m = 0; for (std::size_t i = 0; i != Columns; ++i) m = m * 10 + 9; return m; }();
    static constexpr std::string_view type_name = "decimal";
    static constexpr std::uint64_t digits_only = Columns <= 7 ? (1U << Columns) - 1 : 0;  ///< Columns that hold digits and spaces alone.

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept { return read_one<Columns>(p, out); }
    /// As `load` where `Readable` columns may be read.
    template <std::size_t Readable>
    static constexpr std::uint64_t load_near(const std::uint8_t* p, value& out) noexcept { return read_one<Columns, Readable>(p, out); }
    /// As `load` where `map` describes the columns from bit 0 on, but columns that are neither digits nor spaces are left
    /// to the caller. `Readable` columns may be read.
    template <std::size_t Readable>
    [[gnu::always_inline]] static constexpr std::uint64_t load_mapped(const std::uint8_t* p, const column_map& map, value& out) noexcept {
        return read_mapped<Columns, Readable>(p, map.digits, out);
    }
    static constexpr void store(std::uint8_t* p, value v) noexcept {
        if constexpr (Columns <= 7) write_few_columns<Columns>(p, v);
        else write_columns(p, Columns, v);
    }
};

/// Decimal in `Columns` ASCII columns that may have a leading '-'. [D16]
template <std::size_t Columns>
struct signed_dec : dec<Columns> {
    using value = std::int32_t;
    static constexpr std::int64_t low = -(dec<Columns>::high / 10);
    static constexpr std::string_view type_name = "signed decimal";
    static constexpr std::uint64_t digits_only = 0;

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= dec<Columns>::high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept { return read_signed_columns<Columns>(p, out); }
    template <std::size_t Readable>
    static constexpr std::uint64_t load_near(const std::uint8_t* p, value& out) noexcept { return load(p, out); }
    /// As of `dec`, but nothing is left to the caller.
    template <std::size_t Readable>
    [[gnu::always_inline]] static constexpr std::uint64_t load_mapped(const std::uint8_t* p, const column_map& map, value& out) noexcept {
        if ((map.others & ((1U << Columns) - 1)) != 0) [[unlikely]] return load(p, out) != 0 ? 1 : 0;
        std::uint32_t magnitude = 0;
        const std::uint32_t bad = read_mapped<Columns, Readable>(p, map.digits, magnitude);
        out = static_cast<value>(magnitude);
        return bad;
    }
    static constexpr void store(std::uint8_t* p, value v) noexcept {
        if (v < 0) [[unlikely]] write_signed_columns(p, Columns, v);
        else dec<Columns>::store(p, static_cast<std::uint32_t>(v));
    }
};

/// `xxx.x` in `Columns` ASCII columns, held in tenths. [gateway, "Order_type: circuit_state"; D15]
template <std::size_t Columns>
struct tenths {
    using value = std::uint16_t;
    static constexpr std::size_t size = Columns;
    static constexpr print printed = print::tenths;
    static constexpr bool decimal = true;
    static constexpr std::int64_t low = 0, high = 9999;
    static constexpr std::string_view type_name = "decimal xxx.x";

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept { return read_tenths<Columns>(p, out); }
    static constexpr void store(std::uint8_t* p, value v) noexcept { write_tenths(p, Columns, v); }
};

/// Free text in `Columns` printable characters. The framing has already refused anything else. [D17]
template <std::size_t Columns>
struct chars {
    using value = text<Columns>;
    static constexpr std::size_t size = Columns;
    static constexpr print printed = print::text;
    static constexpr std::string_view type_name = "text";

    static constexpr bool carries(const value& v) noexcept { return v.printable(); }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept {
        if (std::is_constant_evaluated()) for (std::size_t i = 0; i != Columns; ++i) out.columns[i] = static_cast<char>(p[i]);
        else std::memcpy(out.columns.data(), p, Columns);
        return 0;
    }
    static constexpr void store(std::uint8_t* p, const value& v) noexcept {
        if (std::is_constant_evaluated()) for (std::size_t i = 0; i != Columns; ++i) p[i] = static_cast<std::uint8_t>(v.columns[i]);
        else std::memcpy(p, v.columns.data(), Columns);
    }
};

}  // namespace trama::wire
