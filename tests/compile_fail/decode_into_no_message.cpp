// expect: no matching function
#include "trama/daisy/format.hpp"

void use(const trama::daisy::packet& packet) {
    (void)trama::decode<trama::daisy::common::ping>(packet);
    (void)trama::decode<int>(packet);  // wrong
}
