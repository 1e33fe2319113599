#pragma once
#include "harness.hpp"

namespace trama::bench {

/// An answer that was heard.
struct statement {
    std::string question, name, chunk;
    tally said;
};

/// Who contradicts whom, or which contender of `r` nobody else was compared with; empty if the race may be timed.
std::string contradiction(const race& r, const std::vector<statement>& heard);
/// The same of what the contenders' timed code came to: they must be alike, and as many messages and errors as proved.
std::string contradiction(const race& r, const std::vector<statement>& heard, const std::vector<timing>& timed);

}  // namespace trama::bench
