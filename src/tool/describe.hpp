#pragma once

#include "tool/options.hpp"

namespace trama::tool {

/// `trama describe`: the exit status.
int describe(const options& o);

}  // namespace trama::tool
