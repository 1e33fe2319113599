#pragma once

#include <span>

namespace trama::tool {

/// `trama describe [PROTOCOL [MESSAGE]]`: the exit status.
int describe(std::span<char*> arguments);

}  // namespace trama::tool
