// The library at work on can, as it is timed.
#include "can.hpp"

namespace trama::bench {

std::array<library_task<can::format>, std::size(all_tasks)> traits<can::format>::library() { return library_tasks<can::format, false>(); }

}  // namespace trama::bench
