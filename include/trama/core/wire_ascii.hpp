#pragma once

#include "trama/core/decimal.hpp"
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

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept { return read_columns<Columns>(p, out); }
    static constexpr void store(std::uint8_t* p, value v) noexcept { write_columns(p, Columns, v); }
};

/// Decimal in `Columns` ASCII columns that may have a leading '-'. [D16]
template <std::size_t Columns>
struct signed_dec : dec<Columns> {
    using value = std::int32_t;
    static constexpr std::int64_t low = -(dec<Columns>::high / 10);
    static constexpr std::string_view type_name = "signed decimal";

    static constexpr bool carries(std::int64_t v) noexcept { return low <= v && v <= dec<Columns>::high; }
    static constexpr std::uint64_t load(const std::uint8_t* p, value& out) noexcept { return read_signed_columns<Columns>(p, out); }
    static constexpr void store(std::uint8_t* p, value v) noexcept { write_signed_columns(p, Columns, v); }
};

/// `xxx.x` in `Columns` ASCII columns, held in tenths. [gateway, "circuit_state"; D15]
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
