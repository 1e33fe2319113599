#pragma once
#include <optional>
#include <span>

#include "harness.hpp"

namespace trama::bench {

/// One line of the table of targets: the figure is the median over the rounds of one contender's time per byte as a
/// multiple of another's of the same race, or the other way round where the library must be so many times faster.
struct target {
    const char* work;
    const char* race;  ///< Without the size: it is the large stream of the run.
    const char* workload;
    const char* task;
    const char* contender;  ///< The library's if null.
    const char* chunk;
    const char* against;
    bool faster;
    double must, stretch;
};

/// The targets, the only place where they are written down.
std::span<const target> targets();

/// Identity of the race that shows whether `t` is met.
std::string race_of(const target& t, const scale& sizes);
/// The figure of this run; nothing if the race was not run or its contenders did not agree.
std::optional<double> figure(const target& t, std::span<const outcome> all, const scale& sizes);
/// True when `value` is as good as `bound`.
bool is_met(const target& t, double value, double bound);
/// The table, figures and verdicts included, and below it how many are met.
std::string table(std::span<const outcome> all, const scale& sizes);

}  // namespace trama::bench
