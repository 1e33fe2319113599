#pragma once

#include "tool/options.hpp"

namespace trama::tool {

/// `trama decode`: the exit status.
int decode(const options& o);

}  // namespace trama::tool
