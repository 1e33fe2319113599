// expect: nodiscard
// Nothing may have been written: whoever encodes has to look.
#include "trama/daisy/format.hpp"

void use(std::span<std::uint8_t> out) {
    (void)trama::daisy::encode({}, trama::daisy::common::ping{}, out);
    trama::daisy::encode({}, trama::daisy::common::ping{}, out);  // wrong
}
