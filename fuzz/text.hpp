#pragma once
// JSON in and out. The input is text: lines of JSON for `trama encode`, and for can also lines of a candump log.
#include "lines.hpp"

namespace trama::fuzz {

/// Units that `encode` made of a line arrive as one packet; printed by `decode` and encoded again, they are the same units.
template <wire_format F>
void check_there_and_back(std::string_view line) {
    const auto made = tool::encode_line<F>(line, true);
    if (!made.error.empty()) return;
    typename F::decoder decoder;
    // In daisy a text of noise need not bring a decoder into step, so that one is in step already.
    const auto before = traits<F>::landmark();
    read<F>(decoder, before, [](const auto&) {});
    std::size_t packets = 0;
    read<F>(decoder, made.units, [&](const typename F::event& e) {
        ++packets;
        const bool whole = e.code == errc::ok && e.offset == before.size() && e.length == made.units.size();
        require(whole || !traits<F>::arrives(made.units), "what encode made is a packet whole");
        if (!whole) return;
        const auto again = tool::encode_line<F>(line_of<F>(e), true);
        require(again.error.empty(), "encode reads what decode prints");
        require(again.units == made.units, "what encode made comes back from decode and encode");
    });
    // In can, an identifier that nobody follows is foreign.
    require(packets == 1 || decoder.counters().foreign == made.units.size() || !traits<F>::arrives(made.units), "what encode made is one packet");
}

template <wire_format F>
int text(std::span<const std::uint8_t> input) {
    const exact<char> copy(std::span<const char>(reinterpret_cast<const char*>(input.data()), input.size()));
    std::string_view all(copy.all().data(), copy.all().size());
    if constexpr (std::is_same_v<F, can::format>) {
        if (all.starts_with('(')) {
            require_same(library_can_lines(all, tool::per_second), reference_of<F>::lines(all, 1.0), "library and reference say the same about a log");
            return 0;
        }
    }
    for (int lines = 0; !all.empty() && lines != 8; ++lines) {
        const exact<char> block(std::span<const char>(all).first(std::min(all.find('\n'), all.size())));
        const std::string_view line(block.all().data(), block.all().size());
        all.remove_prefix(std::min(all.size(), line.size() + 1));
        check_encoders<F>(line);
        check_there_and_back<F>(line);
    }
    return 0;
}

}  // namespace trama::fuzz
