#include "report.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "build_info.hpp"

namespace trama::bench {

namespace {

std::string text_of(const char* format, auto... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::size_t first(const race& r, role part) {
    const auto at = std::find_if(r.contenders.begin(), r.contenders.end(), [&](const contender& c) { return c.part == part; });
    return static_cast<std::size_t>(at - r.contenders.begin());
}
/// The good baseline: the last one.
std::size_t good_baseline(const race& r) {
    std::size_t found = r.contenders.size();
    for (std::size_t i = 0; i != r.contenders.size(); ++i)
        if (r.contenders[i].part == role::baseline) found = i;
    return found;
}

std::string quoted(const std::string& s) {
    std::string out(1, '"');
    for (const char c : s) {
        if (c == '"' || c == '\\') out.push_back('\\');
        if (c >= 0x20) out.push_back(c);
    }
    out.push_back('"');
    return out;
}

std::string ratio_or(const outcome& o, std::size_t a, std::size_t b, const char* none, const char* format) {
    return b == o.times.size() ? none : text_of(format, ratio(o, a, b));
}

/// Some limits know nothing of messages; their figures are for the messages of the others' stream.
std::uint64_t messages_of(const outcome& o, std::size_t i) {
    if (o.times[i].result.messages != 0) return o.times[i].result.messages;
    for (std::size_t other = 0; other != o.times.size(); ++other)
        if (o.what.contenders[other].part == role::library && o.what.contenders[other].bytes == o.what.contenders[i].bytes)
            return o.times[other].result.messages;
    return 0;
}

}  // namespace

circumstances here() {
    std::string machine = "unknown";
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) { machine = line.substr(line.find(':') + 2); break; }
#if defined(__clang__)
    const std::string compiler = std::string("clang++ ") + __clang_version__;
#else
    const std::string compiler = std::string("g++ ") + __VERSION__;
#endif
    return {machine, compiler, build_flags, build_commit};
}

std::string table(const outcome& o) {
    std::string text = std::string(1, '\n').append(o.what.id()).append("\n");
    if (!o.disagreement.empty()) return text + "  NOT TIMED, the results disagree:\n  " + o.disagreement + "\n";
    text += text_of("  %-26s %-6s %10s %10s %10s %7s %9s %8s %10s\n", "", "chunk", "ns/msg min", "median", "max", "spread", "MB/s", "x limit", "x baseline");
    const std::size_t limit = first(o.what, role::limit), baseline = good_baseline(o.what);
    for (std::size_t i = 0; i != o.times.size(); ++i) {
        const contender& c = o.what.contenders[i];
        const auto& ns = o.times[i].ns;
        const auto [low, high] = std::minmax_element(ns.begin(), ns.end());
        const double middle = median(ns), each = static_cast<double>(std::max<std::uint64_t>(messages_of(o, i), 1));
        text += text_of("  %-26s %-6s %10.2f %10.2f %10.2f %6.0f%% %9.0f", c.name.c_str(), c.chunk.c_str(), *low / each, middle / each, *high / each,
                        100 * (*high - *low) / middle, static_cast<double>(c.bytes) / middle * 1e3);
        text += ratio_or(o, i, limit, "         ", " %8.2f") + ratio_or(o, i, baseline, "", " %10.2f") + "\n";
    }
    return text;
}

std::string json(const circumstances& c, std::span<const outcome> all) {
    std::string text;
    text.append("{\"machine\":").append(quoted(c.machine)).append(",\"compiler\":").append(quoted(c.compiler));
    text.append(",\"flags\":").append(quoted(c.flags)).append(",\"commit\":").append(quoted(c.commit)).append(",\"rows\":[");
    const char* gap = "\n";
    for (const outcome& o : all) {
        if (!o.disagreement.empty()) continue;
        const std::size_t limit = first(o.what, role::limit), baseline = good_baseline(o.what);
        for (std::size_t i = 0; i != o.times.size(); ++i) {
            const contender& one = o.what.contenders[i];
            const auto& ns = o.times[i].ns;
            const auto [low, high] = std::minmax_element(ns.begin(), ns.end());
            const std::uint64_t messages = messages_of(o, i);
            const double each = static_cast<double>(std::max<std::uint64_t>(messages, 1));
            text.append(gap).append("{\"format\":").append(quoted(o.what.format)).append(",\"workload\":").append(quoted(o.what.workload));
            text.append(",\"size\":").append(quoted(o.what.size)).append(",\"chunk\":").append(quoted(one.chunk));
            text.append(",\"task\":").append(quoted(o.what.task)).append(",\"implementation\":").append(quoted(one.name));
            text += text_of(",\"messages\":%llu,\"bytes\":%llu,\"rounds\":%zu", static_cast<unsigned long long>(messages), static_cast<unsigned long long>(one.bytes), ns.size());
            text += text_of(",\"ns_min\":%.4f,\"ns_median\":%.4f,\"ns_max\":%.4f", *low / each, median(ns) / each, *high / each);
            text += text_of(",\"bytes_per_second\":%.0f", static_cast<double>(one.bytes) / median(ns) * 1e9);
            text += ",\"ratio_limit\":" + ratio_or(o, i, limit, "null", "%.4f") + ",\"ratio_baseline\":" + ratio_or(o, i, baseline, "null", "%.4f") + "}";
            gap = ",\n";
        }
    }
    return text + "\n]}\n";
}

}  // namespace trama::bench
