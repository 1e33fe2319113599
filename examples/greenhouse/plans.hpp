#pragma once
// What the masters have their nodes do, and what must come of it.

#include "members.hpp"

namespace greenhouse {

struct plan {
    std::uint8_t node;
    define_function function;
};

inline define_function without_list(std::uint8_t node, can::function what) {
    define_function f{};
    f.node = node;
    f.function = what;
    return f;
}
inline define_function continuous(std::uint8_t node) { return without_list(node, can::function::continuous_all); }
inline define_function asleep(std::uint8_t node) { return without_list(node, can::function::sleep); }
/// Sensors 0 and 1, from eight in the morning to eight in the evening of the first day.
inline define_function by_day(std::uint8_t node) {
    define_function f = without_list(node, can::function::interval_specific);
    f.start = {dawn.year, dawn.month, dawn.day, 8, 0, 0};
    f.end = {dawn.year, dawn.month, dawn.day, 20, 0, 0};
    f.sensor_count = 2;
    f.sensors = {0, 1, 0, 0};
    return f;
}
inline define_function only_soil(std::uint8_t node) {
    define_function f = without_list(node, can::function::continuous_specific);
    f.sensor_count = 1;
    f.sensors = {3, 0, 0, 0};
    return f;
}

/// How many sensors a node has to report between two moments; -1 if that changes in between, give or take ten minutes.
inline int expected_count(const define_function& f, const moment& first, const moment& last) {
    constexpr std::array<std::uint8_t, 4> all{0, 1, 2, 3};
    const auto count = [&](std::int64_t at) { return int{can::sensors_at(f, all, can::moment_at(at), true).count}; };
    const std::int64_t from = can::seconds_of(first) - 600, to = can::seconds_of(last) + 600;
    return count(from) == count(to) && count(from) == count((from + to) / 2) ? count(from) : -1;
}

}  // namespace greenhouse
