#pragma once

#include "trama/trama.hpp"

namespace trama::tool {

/// Writes one event as a line without its end: `trama decode`'s output. True when it is an error or has violations.
template <wire_format F>
bool print_event(text_sink& out, const typename F::event& e, notation n);

extern template bool print_event<daisy::format>(text_sink&, const daisy::event&, notation);
extern template bool print_event<can::format>(text_sink&, const can::event&, notation);
extern template bool print_event<gateway::format>(text_sink&, const gateway::event&, notation);

/// Writes the line, without its end, for line `number` of a log, which is none of candump's.
void print_bad_line(text_sink& out, std::uint64_t number, notation n);

/// Room for the longest line.
inline constexpr std::size_t longest_line = 1 << 15;

}  // namespace trama::tool
