// expect: deleted
// The view would outlive its characters.
#include "trama/core/text.hpp"

constexpr trama::text<10> kept{"A"};
static_assert(kept.view() == "A");
const std::string_view gone = trama::text<10>{"A"}.view();  // wrong
