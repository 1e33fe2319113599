// Decodes a hostile stream, in chunks: what a unit costs at most, as far as known.
//
//   hostile daisy|can|gateway CHUNK UNITS
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "../hostile.hpp"
#include "trama/trama.hpp"

using namespace trama;

namespace {

constexpr std::size_t longest = std::size_t{1} << 14;

/// Always makes the whole stream, so that runs differ by what they decode alone.
template <wire_format F>
int run(const std::vector<typename F::unit>& stream, std::size_t chunk, std::size_t units) {
    typename F::decoder decoder;
    std::size_t units_seen = 0;
    for (std::size_t at = 0; at < units; at += chunk) {
        const auto piece = std::span(stream).subspan(at, std::min(chunk, units - at));
        read<F>(decoder, piece, [&](const auto& event) { units_seen += event.length; });
    }
    return units_seen + decoder.pending() == units ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const auto chunk = static_cast<std::size_t>(std::atoi(argv[2])), units = static_cast<std::size_t>(std::atoi(argv[3]));
    if (chunk == 0 || units > longest) return 2;
    if (std::strcmp(argv[1], "daisy") == 0) return run<daisy::format>(bench::hostile_daisy(longest), chunk, units);
    if (std::strcmp(argv[1], "daisy, none intact") == 0) return run<daisy::format>(bench::hostile_daisy(longest, false), chunk, units);
    if (std::strcmp(argv[1], "can") == 0) return run<can::format>(bench::hostile_can(longest), chunk, units);
    if (std::strcmp(argv[1], "gateway") == 0) return run<gateway::format>(bench::hostile_gateway(longest), chunk, units);
    return 2;
}
