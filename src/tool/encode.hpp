#pragma once

#include "tool/options.hpp"

namespace trama::tool {

/// `trama encode`: the exit status.
int encode(const options& o);

}  // namespace trama::tool
