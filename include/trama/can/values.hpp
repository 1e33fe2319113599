#pragma once

#include "trama/core/layout.hpp"

namespace trama::can {

/// What sensors a node samples and when: two letters, first × 256 + second. [can §1]
enum class function : std::uint16_t {
    continuous_all = 'C' << 8 | 'A', continuous_specific = 'C' << 8 | 'S', sleep = 'S' << 8 | 'A',
    interval_all = 'I' << 8 | 'A', interval_specific = 'I' << 8 | 'S',
};
consteval auto names(function) {
    using enum function;
    return std::array{named{continuous_all, "continuous_all"}, named{continuous_specific, "continuous_specific"}, named{sleep, "sleep"},
                      named{interval_all, "interval_all"}, named{interval_specific, "interval_specific"}};
}
/// True for the functions that have a start and an end.
constexpr bool has_interval(function f) noexcept { return f == function::interval_all || f == function::interval_specific; }
/// True for the functions that name their sensors.
constexpr bool names_sensors(function f) noexcept { return f == function::continuous_specific || f == function::interval_specific; }

inline constexpr rule zero = between(0, 0);
inline constexpr rule months = between(1, 12);
inline constexpr rule days = between(1, 31);
inline constexpr rule hours = between(0, 23);
inline constexpr rule sixtieths = between(0, 59);  ///< Minutes and seconds.
inline constexpr rule message_ids = between(0, 200);

/// Date and time of day; all zero where a function has no interval. [can §1]
struct moment {
    std::uint16_t year = 0;   ///< 0..9999.
    std::uint8_t month = 0;   ///< 1..12.
    std::uint8_t day = 0;     ///< 1..31.
    std::uint8_t hour = 0;    ///< 0..23.
    std::uint8_t minute = 0;  ///< 0..59.
    std::uint8_t second = 0;  ///< 0..59.

    static constexpr fields layout{
        field<&moment::year, wire::century_year>{"year", {}, "century, then year: 20, 11 is 2011"},
        field<&moment::month, wire::u8>{"month", between(0, 12), "month, not 0 in an interval"},
        field<&moment::day, wire::u8>{"day", between(0, 31), "day, not 0 in an interval"},
        field<&moment::hour, wire::u8>{"hour", hours, "hour"},
        field<&moment::minute, wire::u8>{"minute", sixtieths, "minute"},
        field<&moment::second, wire::u8>{"second", sixtieths, "second"},
    };
    friend constexpr auto operator<=>(const moment&, const moment&) = default;
};

/// A sensor and what it measured. [can §2.1]
struct reading {
    std::uint8_t sensor = 0;
    std::uint8_t value = 0;

    static constexpr fields layout{
        field<&reading::sensor, wire::u8>{"sensor", {}, "sensor"},
        field<&reading::value, wire::u8>{"value", {}, "measured value"},
    };
    friend constexpr bool operator==(const reading&, const reading&) = default;
};

}  // namespace trama::can
