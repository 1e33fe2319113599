// expect: nodiscard
#include "trama/daisy/format.hpp"

void use(const trama::daisy::packet& packet, trama::daisy::common::ping& ping) {
    if (trama::decode_into(packet, ping)) return;
    trama::decode_into(packet, ping);  // wrong
}
