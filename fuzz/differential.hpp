#pragma once
// The library against the reference in tests/reference, which was written from the specification alone.
#include "lines.hpp"

namespace trama::fuzz {

/// Both say the same about the stream, with and without silences, and both encode two of the lines alike.
template <wire_format F>
int differential(std::span<const std::uint8_t> input) {
    dice d(hash_of(input));
    text_lines lines;
    if constexpr (std::is_same_v<F, can::format>) {
        constexpr std::uint64_t timeout = traits<F>::patience;
        std::string log;
        for (const auto& f : traits<F>::timed_units_from(input, timeout)) log += traits<F>::log_line(f) + "\n";
        lines = library_can_lines(log, timeout * 1000);
        require_same(lines, reference_of<F>::lines(log, static_cast<double>(timeout) * 1e-6), "library and reference say the same about a log");
    } else {
        lines = library_lines<F>(input);
        require_same(lines, reference_of<F>::lines(input, {}), "library and reference say the same about a stream");
        if constexpr (requires(typename F::decoder x) { x.idle(); }) {
            std::vector<std::size_t> silences(2);
            for (auto& s : silences) s = d.below(input.size() + 1);
            std::sort(silences.begin(), silences.end());
            require_same(library_lines<F>(input, silences), reference_of<F>::lines(input, silences), "library and reference say the same about a stream with silences");
        }
    }
    for (int turn = 0; turn != 2 && !lines.empty(); ++turn) {
        const exact<char> line{std::span<const char>(lines[d.below(lines.size())])};
        check_encoders<F>({line.all().data(), line.all().size()});
    }
    return 0;
}

}  // namespace trama::fuzz
