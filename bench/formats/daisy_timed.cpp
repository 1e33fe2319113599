// The library at work on daisy, as it is timed.
#include "daisy.hpp"

namespace trama::bench {

std::array<library_task<daisy::format>, std::size(all_tasks)> traits<daisy::format>::library() { return library_tasks<daisy::format, false>(); }
library_task<daisy::format> traits<daisy::format>::typed_ahead() { return typed<daisy::format, false, false, true>; }

}  // namespace trama::bench
