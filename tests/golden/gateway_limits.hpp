#pragma once

#include "golden/check.hpp"
#include "golden/limits.hpp"
#include "golden/slow_numbers.hpp"
#include "trama/trama.hpp"

namespace trama::golden {

template <class M>
constexpr auto allowed(const M& m) { return passes<gateway::format>({}, m); }
template <class M, class... More>
constexpr auto refused(const M& m, const More&... expected) { return fails<gateway::format>({}, m, expected...); }

/// `field` is the position in the layout; both encoders refuse.
template <class M>
constexpr bool no_room(const M& m, field_ref field) { return unwritable<gateway::format>({}, m, field); }

/// The columns of each record a second time, as the document's tables give them: width and kind, the type first.
inline std::string_view shape_of(gateway::order_type type) {
    switch (static_cast<int>(type)) {
        case 1: case 2: case 3: return "3n 5n 5n 5n 5n 2n 10t 10t 10t";
        case 10: case 15: case 30: return "3n 5n 5n 5n";
        case 20: return "3n 5n 5n";
        case 21: case 22: case 23: return "3n 5n 5n 10t 10t";
        case 50: return "3n 5n";
        case 100: return "3n 5n 5n 3n 5n 10t";
        case 101: return "3n 5n 5n 3n 5n";
        case 102: return "3n 5n 5n 3n 5n 80t";
        case 200: return "3n 5n 5n 4n 1n 5n 3n 5n 5n 5s 1n 1n 3n 5n 5n 5n 2n 10t 10t 10t 1n 10t 10t 10t 1n 3n 5n 5n 5n 2n 10t 10t 10t 1n 10t 10t 10t";
        case 201: return "3n 5n 5d 5d 5n 7n 1n 1n";
        default: return "";
    }
}

/// True when the damaged byte lies in a number that still reads the same, as "  1" and " 01" do.
inline constexpr auto same_number = [](const auto& row, const auto& damaged) {
    const std::string before(row.wire.begin(), row.wire.end()), after(damaged.begin(), damaged.end());
    std::string_view shape = shape_of(row.value.key);
    for (std::size_t at = 1; !shape.empty();) {
        std::size_t width = 0, used = 0;
        while (shape[used] >= '0' && shape[used] <= '9') width = width * 10 + static_cast<std::size_t>(shape[used++] - '0');
        const std::string was = before.substr(at, width), is = after.substr(at, width);
        if (was != is) return shape[used] != 't' && slow_field(shape[used], was) == slow_field(shape[used], is);
        at += width;
        shape.remove_prefix(std::min(shape.size(), used + 2));
    }
    return false;
};

}  // namespace trama::golden
