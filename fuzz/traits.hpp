#pragma once
// How fuzz input becomes the units of a medium. A format specialises `traits`; most take `octet_traits` as they are.
#include <string>

#include "support.hpp"

namespace trama::fuzz {

/// What the harness has to know about format `F` beyond the wire_format concept; see fuzz/formats/.
template <class F>
struct traits;

/// Where the units that event `e` covers lie among `units`, all that the decoder read; those of others may lie between them.
template <class F>
std::vector<std::size_t> units_of(const auto& units, const auto& e) {
    std::vector<std::size_t> places;
    for (auto at = static_cast<std::size_t>(e.offset); places.size() != e.length; ++at) {
        require(at < units.size(), "an event covers units that were read");
        if constexpr (requires { traits<F>::belongs(units[at], e); })
            if (!traits<F>::belongs(units[at], e)) continue;
        places.push_back(at);
    }
    return places;
}

/// For formats whose unit is an octet: the input is the stream.
struct octet_traits {
    static constexpr std::size_t unit_octets = 1;

    static octets units_from(std::span<const std::uint8_t> input) { return {input.begin(), input.end()}; }
    static octets octets_from(std::span<const std::uint8_t> units) { return {units.begin(), units.end()}; }
    /// Units behind which a decoder is in step; none where it always is.
    static octets landmark() { return {}; }
    /// Whether a packet that `encode` made, if need be unchecked, arrives behind a landmark whatever it says.
    static bool arrives(std::span<const std::uint8_t>) { return true; }
    /// The stream as `trama decode --hex` reads it.
    static void print_wire(std::span<const std::uint8_t> stream) {
        for (const std::uint8_t b : stream) std::printf("%02x", b);
        std::printf("\n");
    }
};

}  // namespace trama::fuzz
