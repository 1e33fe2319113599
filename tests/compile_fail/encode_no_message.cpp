// expect: no matching function
// What has a layout is not yet a message: an address can't be sent on its own.
#include "trama/daisy/format.hpp"

void use(std::span<std::uint8_t> out) {
    (void)trama::daisy::encode({}, trama::daisy::common::ping{}, out);
    (void)trama::daisy::encode({}, trama::daisy::address{}, out);  // wrong
}
