// expect: no matching function
#include "trama/daisy/format.hpp"

void use(std::span<std::uint8_t> out) {
    (void)trama::daisy::encode({trama::daisy::everyone, trama::daisy::board(0, 0)}, trama::daisy::common::ping{}, out);
    (void)trama::daisy::encode(trama::daisy::common::ping{}, out);  // wrong
}
