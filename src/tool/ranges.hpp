#pragma once

#include "tool/options.hpp"

namespace trama::tool {

/// Decodes a part of a file (`--range`; daisy and gateway only), or all of it on several cores (`--jobs`): the exit status.
int decode_parts(const options& o);

}  // namespace trama::tool
