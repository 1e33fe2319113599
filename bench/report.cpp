#include "report.hpp"

#include <sys/utsname.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <thread>

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

/// What times are divided by: the messages that the stream was made of; the whole stream if it was made of none.
double divisor(const contender& c) { return static_cast<double>(std::max<std::uint64_t>(c.messages, 1)); }

/// The processor's name, or where there is none its numbers, as on aarch64; then cores and architecture.
std::string machine() {
    std::string name, numbers;
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; name.empty() && std::getline(info, line);) {
        const std::string value = line.substr(std::min(line.size(), line.find(':') + 1));
        if (line.starts_with("model name")) name = value.substr(1);
        else if (line.starts_with("CPU implementer") && numbers.empty()) numbers = "CPU implementer" + value;
        else if (line.starts_with("CPU part") && numbers.find("part") == std::string::npos) numbers += " part" + value;
    }
    if (name.empty()) name = numbers.empty() ? "unknown processor" : numbers;
    utsname system{};
    const std::string architecture = uname(&system) == 0 ? system.machine : "unknown architecture";
    return name + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, " + architecture;
}

}  // namespace

circumstances here() {
#if defined(__clang__)
    const std::string compiler = std::string("clang++ ") + __clang_version__;
#else
    const std::string compiler = std::string("g++ ") + __VERSION__;
#endif
    return {machine(), compiler, build_flags, build_commit};
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
        const double middle = median(ns), each = divisor(c);
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
            const double each = divisor(one);
            text.append(gap).append("{\"format\":").append(quoted(o.what.format)).append(",\"workload\":").append(quoted(o.what.workload));
            text.append(",\"size\":").append(quoted(o.what.size)).append(",\"chunk\":").append(quoted(one.chunk));
            text.append(",\"task\":").append(quoted(o.what.task)).append(",\"implementation\":").append(quoted(one.name));
            text += text_of(",\"messages\":%llu,\"bytes\":%llu,\"rounds\":%zu", static_cast<unsigned long long>(one.messages), static_cast<unsigned long long>(one.bytes), ns.size());
            text += text_of(",\"ns_min\":%.4f,\"ns_median\":%.4f,\"ns_max\":%.4f", *low / each, median(ns) / each, *high / each);
            text += ",\"ratio_limit\":" + ratio_or(o, i, limit, "null", "%.4f") + ",\"ratio_baseline\":" + ratio_or(o, i, baseline, "null", "%.4f") + "}";
            gap = ",\n";
        }
    }
    return text + "\n]}\n";
}

}  // namespace trama::bench
