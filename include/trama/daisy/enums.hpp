#pragma once

#include <array>
#include <cstdint>

#include "trama/core/names.hpp"

namespace trama::daisy {

/// Turning sense of a DC motor. [daisy §6.1]
enum class direction : std::uint8_t { clockwise, counter_clockwise };
consteval auto names(direction) {
    using enum direction;
    return std::array{named{clockwise, "clockwise"}, named{counter_clockwise, "counter_clockwise"}};
}

/// Change of a switch that raises an alarm; a board need not know `any_change`. [daisy §7.12]
enum class trigger : std::uint8_t { none, rising_edge, falling_edge, any_change };
consteval auto names(trigger) {
    using enum trigger;
    return std::array{named{none, "none"}, named{rising_edge, "rising_edge"}, named{falling_edge, "falling_edge"}, named{any_change, "any_change"}};
}

/// Logic level of a switch. [daisy §7.13]
enum class state : std::uint8_t { low, high };
consteval auto names(state) {
    using enum state;
    return std::array{named{low, "low"}, named{high, "high"}};
}

}  // namespace trama::daisy
