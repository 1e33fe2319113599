#pragma once

#include <algorithm>
#include <vector>

#include "tool/random_file.hpp"
#include "trama/daisy/footing.hpp"
#include "trama/daisy/format.hpp"
#include "trama/gateway/footing.hpp"
#include "trama/gateway/format.hpp"

namespace trama::tool {

template <class F>
inline constexpr bool is_daisy = std::is_same_v<F, daisy::format>;

/// A place of a file where one decoder may end and another begin, and where the other has to join for that.
struct seam {
    std::uint64_t join = 0, place = 0;
};

template <class F>
std::size_t find_footing(std::span<const std::uint8_t> bytes, std::size_t from) {
    if constexpr (is_daisy<F>) return daisy::footing(bytes, from);
    else if (from == 0 && bytes[0] == gateway::stx) return 0;
    else return gateway::footing(bytes, std::max<std::size_t>(from, 1));
}

/// The first seam at or behind `from`, searched in windows that depend on `from` alone: all who ask find the same.
template <class F>
seam seam_at(const random_file& file, std::uint64_t from) {
    constexpr std::size_t lead = is_daisy<F> ? daisy::footing_lead : gateway::footing_lead, widest = std::size_t{1} << 20;
    if (from == 0) return {};
    std::vector<std::uint8_t> window(std::size_t{1} << 14);
    while (from < file.size()) {
        const std::uint64_t join = from - std::min<std::uint64_t>(from, lead);
        const auto bytes = file.read(join, window);
        const std::size_t found = find_footing<F>(bytes, static_cast<std::size_t>(from - join));
        if (found < bytes.size()) return {join, join + found};
        if (join + bytes.size() == file.size()) break;
        if (window.size() < widest) window.resize(4 * window.size());
        else from += widest / 2;
    }
    return {file.size(), file.size()};
}

}  // namespace trama::tool
