#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trama/trama.hpp"

namespace trama::tool {

/// What a JSON line became: the units of a packet, or why there are none.
template <wire_format F>
struct encoded {
    std::vector<typename F::unit> units;
    std::string error;
};

/// Turns a line of `trama decode`'s JSON into a packet.
template <wire_format F>
encoded<F> encode_line(std::string_view line, bool unchecked);

extern template encoded<daisy::format> encode_line(std::string_view, bool);
extern template encoded<can::format> encode_line(std::string_view, bool);
extern template encoded<gateway::format> encode_line(std::string_view, bool);

}  // namespace trama::tool
