// The library at work on gateway, as it is timed.
#include "gateway.hpp"

namespace trama::bench {

std::array<library_task<gateway::format>, std::size(all_tasks)> traits<gateway::format>::library() { return library_tasks<gateway::format, false>(); }

}  // namespace trama::bench
