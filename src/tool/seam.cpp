#include "tool/seam.hpp"

#include <algorithm>
#include <vector>

#include "tool/log_decoder.hpp"
#include "trama/daisy/footing.hpp"
#include "trama/gateway/footing.hpp"

namespace trama::tool {

namespace {

template <class F>
std::size_t find_footing(std::span<const std::uint8_t> bytes, std::size_t from) {
    static_assert(is_daisy<F> || is_gateway<F>, "each format has its own rule");
    if constexpr (is_daisy<F>) return daisy::footing(bytes, from);
    else if (from == 0 && bytes[0] == gateway::stx) return 0;
    else return gateway::footing(bytes, std::max<std::size_t>(from, 1));
}

/// In a log: the first line from `from` on before which a decoder that joins at the first whole line keeps nothing.
template <>
std::size_t find_footing<can::format>(std::span<const std::uint8_t> bytes, std::size_t from) {
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

/// How far before a cut one has to join to find it.
template <class F>
constexpr std::size_t lead() {
    static_assert(is_daisy<F> || is_gateway<F>, "each format has its own rule");
    return is_daisy<F> ? daisy::footing_lead : gateway::footing_lead;
}
template <>
constexpr std::size_t lead<can::format>() { return std::size_t{1} << 12; }

std::uint64_t lines_between(const random_file& file, std::uint64_t from, std::uint64_t to) {
    std::vector<std::uint8_t> block(std::size_t{1} << 16);
    std::uint64_t lines = 0;
    while (from < to) {
        const auto bytes = file.read(from, std::span{block}.first(static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), to - from))));
        lines += static_cast<std::uint64_t>(std::count(bytes.begin(), bytes.end(), '\n'));
        from += bytes.size();
    }
    return lines;
}

}  // namespace

template <class F>
seam seam_at(const random_file& file, std::uint64_t from, const seam& before) {
    constexpr std::size_t widest = std::size_t{1} << 20;
    if (from == 0) return {};
    std::vector<std::uint8_t> window(std::size_t{1} << 14);
    while (from < file.size()) {
        const std::uint64_t join = from - std::min<std::uint64_t>(from, lead<F>());
        const auto bytes = file.read(join, window);
        const std::size_t found = find_footing<F>(bytes, static_cast<std::size_t>(from - join));
        if (found < bytes.size()) {
            if constexpr (std::is_same_v<F, can::format>) return {join + found, join + found, before.lines + lines_between(file, before.place, join + found)};
            else return {join, join + found, 0};
        }
        if (join + bytes.size() == file.size()) break;
        if (window.size() < widest) window.resize(4 * window.size());
        else from += widest / 2;
    }
    return {file.size(), file.size(), 0};
}

template seam seam_at<daisy::format>(const random_file&, std::uint64_t, const seam&);
template seam seam_at<can::format>(const random_file&, std::uint64_t, const seam&);
template seam seam_at<gateway::format>(const random_file&, std::uint64_t, const seam&);

}  // namespace trama::tool
