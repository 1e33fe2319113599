// expect: non-const lvalue reference
// `next` takes from the front of the caller's span, and what is left has to be visible at the call.
#include "trama/daisy/format.hpp"

void use(trama::daisy::decoder& decoder, std::span<const std::uint8_t> in) {
    (void)decoder.next(in);
    (void)decoder.next(std::span<const std::uint8_t>{});  // wrong
}
