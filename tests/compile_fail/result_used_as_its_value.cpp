// expect: cannot convert|no viable conversion
// The value is behind `*`, so that the check is not forgotten by accident.
#include "trama/daisy/format.hpp"

std::size_t use(std::span<std::uint8_t> out) {
    const auto size = trama::daisy::encode({}, trama::daisy::common::ping{}, out);
    if (!size) return 0;
    return size;  // wrong
    return *size;
}
