// expect: no matching function
#include "trama/daisy/format.hpp"
#include "trama/gateway/format.hpp"

void use(const trama::daisy::packet& packet) {
    (void)trama::decode<trama::daisy::dc_motor::set_encoder>(packet);
    (void)trama::decode<trama::gateway::load>(packet);  // wrong
}
