#pragma once

#include "tool/options.hpp"

namespace trama::tool {

/// Decodes a part of a file, or all of it on several cores: `--range`, `--jobs`. daisy and gateway only.
int decode_parts(const options& o);

}  // namespace trama::tool
