#pragma once

#include "trama/can/messages.hpp"

/// When a node samples which sensors, and the calendar that this takes. [can §1]
namespace trama::can {

/// Days from a day long before the year 0 to a date of the Gregorian calendar, as if it had always held. Day and month
/// from 1.
constexpr std::int64_t days_of(unsigned year, unsigned month, unsigned day) noexcept {
    // Years begin in March, so that the leap day is a year's last; 400 of them more keep everything above 0.
    const std::int64_t y = std::int64_t{year} + 400 - (month <= 2 ? 1 : 0);
    const std::int64_t m = (std::int64_t{month} + 9) % 12;
    return 365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1;
}

/// Seconds since that day; a month or day of 0 counts as 1. For differences and for `moment_at`.
constexpr std::int64_t seconds_of(const moment& t) noexcept {
    const std::int64_t day_count = days_of(t.year, t.month == 0 ? 1U : t.month, t.day == 0 ? 1U : t.day);
    return ((day_count * 24 + t.hour) * 60 + t.minute) * 60 + t.second;
}
inline constexpr std::int64_t first_second = seconds_of({0, 1, 1, 0, 0, 0});
inline constexpr std::int64_t last_second = seconds_of({9999, 12, 31, 23, 59, 59});

/// The moment of a number of seconds, as `seconds_of` counts them; the nearest one of the years 0..9999.
constexpr moment moment_at(std::int64_t seconds) noexcept {
    seconds = seconds < first_second ? first_second : seconds > last_second ? last_second : seconds;
    const std::int64_t day_count = seconds / 86400, rest = seconds % 86400;
    const std::int64_t era = day_count / 146097, day_of_era = day_count % 146097;
    const std::int64_t year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36524 - day_of_era / 146096) / 365;
    const std::int64_t day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    const std::int64_t m = (5 * day_of_year + 2) / 153;
    const std::int64_t month = m < 10 ? m + 3 : m - 9;
    moment t{};
    t.year = static_cast<std::uint16_t>(400 * (era - 1) + year_of_era + (month <= 2 ? 1 : 0));
    t.month = static_cast<std::uint8_t>(month);
    t.day = static_cast<std::uint8_t>(day_of_year - (153 * m + 2) / 5 + 1);
    t.hour = static_cast<std::uint8_t>(rest / 3600);
    t.minute = static_cast<std::uint8_t>(rest / 60 % 60);
    t.second = static_cast<std::uint8_t>(rest % 60);
    return t;
}

/// A calendar clock without a crystal: it was right once and counts the caller's time since.
class calendar {
public:
    /// `second` is one second in the caller's unit of time, not 0.
    constexpr explicit calendar(std::uint64_t second) noexcept : second_(second) {}

    constexpr void set(const moment& t, std::uint64_t now) noexcept {
        base_ = seconds_of(t);
        set_at_ = now;
        known_ = true;
    }
    /// False until it was set.
    constexpr bool known() const noexcept { return known_; }
    /// Date and time; all zero until it was set.
    constexpr moment at(std::uint64_t now) const noexcept {
        if (!known_) return {};
        const std::uint64_t gone = now > set_at_ ? (now - set_at_) / second_ : 0;
        return moment_at(base_ + static_cast<std::int64_t>(gone));
    }

private:
    std::uint64_t second_;
    std::uint64_t set_at_ = 0;
    std::int64_t base_ = 0;
    bool known_ = false;
};

/// The sensors that are active, in the order in which the node has them. At most four fit into a reply. [D8]
struct active_sensors {
    std::uint8_t count = 0;               ///< 0..4.
    std::array<std::uint8_t, 4> ids{};

    friend constexpr bool operator==(const active_sensors&, const active_sensors&) = default;
};

/// Which sensors `f` makes active at `t`, of a node that has `present` of them. A node without a function, or asleep,
/// has none; an interval lasts from its start to its end, both included, without a break; while the time is not known
/// (`clock` false) no interval holds. A sensor that the node lacks is left out.
constexpr active_sensors sensors_at(const define_function& f, std::span<const std::uint8_t> present, const moment& t, bool clock) noexcept {
    active_sensors active{};
    const bool continuous = f.function == function::continuous_all || f.function == function::continuous_specific;
    const bool inside = has_interval(f.function) && clock && f.start <= t && t <= f.end;
    if (!continuous && !inside) return active;
    for (const std::uint8_t id : present) {
        bool wanted = !names_sensors(f.function);
        for (std::size_t i = 0; i != f.sensor_count && i != f.sensors.size(); ++i) wanted = wanted || (names_sensors(f.function) && f.sensors[i] == id);
        if (wanted && active.count != active.ids.size()) active.ids[active.count++] = id;
    }
    return active;
}

}  // namespace trama::can
