#pragma once
#include <span>

#include "harness.hpp"

namespace trama::bench {

/// What was measured where.
struct circumstances {
    std::string machine, compiler, flags, commit;
};
circumstances here();

/// One race as lines of the terminal's table.
std::string table(const outcome& o);
/// Everything as one JSON object.
std::string json(const circumstances& c, std::span<const outcome> all);

}  // namespace trama::bench
