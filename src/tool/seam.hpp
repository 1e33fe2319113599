#pragma once

#include <algorithm>
#include <vector>

#include "tool/log_decoder.hpp"
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
    std::uint64_t lines = 0;  ///< Of a log, before `place`.
};

template <class F>
std::size_t find_footing(std::span<const std::uint8_t> bytes, std::size_t from) {
    if constexpr (is_daisy<F>) return daisy::footing(bytes, from);
    else if (from == 0 && bytes[0] == gateway::stx) return 0;
    else return gateway::footing(bytes, std::max<std::size_t>(from, 1));
}

/// In a log: the first line from `from` on before which a decoder that joins at the first whole line keeps nothing.
template <>
inline std::size_t find_footing<can::format>(std::span<const std::uint8_t> bytes, std::size_t from) {
    log_decoder probe(can::never);
    std::size_t at = 0;
    for (bool joined = false; at != bytes.size(); joined = true) {
        const auto rest = bytes.subspan(at);
        const auto line = rest.first(static_cast<std::size_t>(std::find(rest.begin(), rest.end(), '\n') - rest.begin()));
        if (line.size() == rest.size()) return bytes.size();
        at += line.size() + 1;
        if (joined) probe.read(rest.first(line.size() + 1), [](const can::event&) {}, [](std::uint64_t) {});
        if (at >= from && probe.settled()) return at;
    }
    return at;
}

template <class F>
inline constexpr std::size_t seam_lead = std::size_t{1} << 12;
template <>
inline constexpr std::size_t seam_lead<daisy::format> = daisy::footing_lead;
template <>
inline constexpr std::size_t seam_lead<gateway::format> = gateway::footing_lead;

/// The first seam at or behind `from`, searched in windows that depend on `from` alone: all who ask find the same.
template <class F>
seam seam_at(const random_file& file, std::uint64_t from) {
    constexpr std::size_t lead = seam_lead<F>, widest = std::size_t{1} << 20;
    if (from == 0) return {};
    std::vector<std::uint8_t> window(std::size_t{1} << 14);
    while (from < file.size()) {
        const std::uint64_t join = from - std::min<std::uint64_t>(from, lead);
        const auto bytes = file.read(join, window);
        const std::size_t found = find_footing<F>(bytes, static_cast<std::size_t>(from - join));
        if (found < bytes.size()) return {std::is_same_v<F, can::format> ? join + found : join, join + found};
        if (join + bytes.size() == file.size()) break;
        if (window.size() < widest) window.resize(4 * window.size());
        else from += widest / 2;
    }
    return {file.size(), file.size()};
}

/// The same for one who goes through the file from seam to seam: with the lines counted.
template <class F>
seam seam_behind(const random_file& file, const seam& before, std::uint64_t from) {
    seam found = seam_at<F>(file, from);
    if constexpr (std::is_same_v<F, can::format>) {
        found.lines = before.lines;
        std::vector<std::uint8_t> block(std::size_t{1} << 16);
        for (std::uint64_t at = before.place; at < found.place;) {
            const auto bytes = file.read(at, std::span{block}.first(static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), found.place - at))));
            found.lines += static_cast<std::uint64_t>(std::count(bytes.begin(), bytes.end(), '\n'));
            at += bytes.size();
        }
    }
    return found;
}

}  // namespace trama::tool
