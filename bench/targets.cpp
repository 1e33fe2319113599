#include "targets.hpp"

#include <algorithm>
#include <cstdio>

namespace trama::bench {

namespace {

constexpr const char* clean_daisy = "trama, clean random mix";

constexpr target all_targets[] = {
    {"daisy framing + CRC, x bare LEN walk", "daisy", "random mix", "framing", "trama", "whole", "LEN walk", false, 1.6, 1.25},
    {"daisy typed, in-order visitor, random mix, x walk", "daisy", "random mix", "typed", "trama, read_ahead", "whole", "LEN walk", false, 11, 6},
    {"daisy typed, in-order visitor, periodic traffic, x walk", "daisy", "periodic", "typed", "trama", "whole", "LEN walk", false, 4, 3},
    {"daisy garbage, ns per byte / clean framing", "daisy", "garbage", "framing", "trama", "whole", clean_daisy, false, 8, 3},
    {"daisy hostile stream, ns per byte / clean framing", "daisy", "hostile", "framing", "trama", "whole", clean_daisy, false, 8, 3},
    {"daisy encode, x memcpy of the output", "daisy", "commands", "encode", "trama", "whole", "memcpy of the output", false, 6, 4},
    {"can reassembly + typed in-order visitor, x bare frame walk", "can", "interleaved", "typed", "trama", "whole", "frame walk", false, 20, 10},
    {"gateway framing + validation, x vector validity pass", "gateway", "85 % cart_state", "framing", "trama", "whole", "validity pass", false, 1.4, 1.2},
    {"gateway every field typed + validated, x validity pass", "gateway", "85 % cart_state", "validated", "trama", "whole", "validity pass", false, 11, 6},
    {"gateway every field, times faster than substr/stoull", "gateway", "85 % cart_state", "validated", "trama", "whole", "substr and stoull", true, 12, 25},
    {"gateway every field, times faster than trim + from_chars", "gateway", "85 % cart_state", "validated", "trama", "whole", "trim and from_chars", true, 4, 8},
    {"gateway two fields by view, x framing alone", "gateway", "85 % cart_state", "two fields by view", "trama", "whole", "trama, framing alone", false, 1.3, 1.1},
    {"gateway encode, times faster than to_string", "gateway", "cart_state", "encode", "trama", "whole", "to_string", true, 4, 15},
    {"daisy framing in 1460-byte chunks, x whole", "daisy", "random mix", "framing", "trama", "1460", "trama", false, 1.15, 1.05},
    {"daisy typed in 1460-byte chunks, x whole", "daisy", "random mix", "typed", "trama", "1460", "trama", false, 1.15, 1.05},
    {"can typed in 1460-byte chunks, x whole", "can", "interleaved", "typed", "trama", "1460", "trama", false, 1.15, 1.05},
    {"gateway framing in 1460-byte chunks, x whole", "gateway", "85 % cart_state", "framing", "trama", "1460", "trama", false, 1.15, 1.05},
    {"gateway validated in 1460-byte chunks, x whole", "gateway", "85 % cart_state", "validated", "trama", "1460", "trama", false, 1.15, 1.05},
};

std::string line(const char* format, auto... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace

std::span<const target> targets() { return all_targets; }

std::string race_of(const target& t, const scale& sizes) {
    return race{t.race, t.workload, size_name(sizes.large), t.task, {}}.id();
}

std::optional<double> figure(const target& t, std::span<const outcome> all, const scale& sizes) {
    for (const outcome& o : all) {
        if (o.what.id() != race_of(t, sizes) || !o.disagreement.empty()) continue;
        const std::size_t a = find(o.what, t.contender, t.chunk), b = find(o.what, t.against);
        if (a == o.times.size() || b == o.times.size()) continue;
        return t.faster ? ratio(o, b, a) : ratio(o, a, b);
    }
    return std::nullopt;
}

bool is_met(const target& t, double value, double bound) { return t.faster ? value >= bound : value <= bound; }

std::string table(std::span<const outcome> all, const scale& sizes) {
    std::string text = line("%-58s %8s %8s %8s  %s\n", "work", "must", "stretch", "figure", "");
    std::size_t met = 0, stretched = 0;
    for (const target& t : targets()) {
        const auto value = figure(t, all, sizes);
        const char* sign = t.faster ? ">=" : "<=";
        text += line("%-58s %s %5.4g %s %5.4g ", t.work, sign, t.must, sign, t.stretch);
        if (!value) {
            text += "       -  not run\n";
            continue;
        }
        const bool must = is_met(t, *value, t.must), stretch = is_met(t, *value, t.stretch);
        met += must ? 1 : 0;
        stretched += stretch ? 1 : 0;
        text += line("%8.2f  %s\n", *value, stretch ? "met, stretch too" : must ? "met" : "missed");
    }
    return text + line("%zu of %zu targets met, %zu of them with the stretch\n", met, targets().size(), stretched);
}

}  // namespace trama::bench
