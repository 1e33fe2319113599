// expect: no matching function
#include "trama/daisy/format.hpp"
#include "trama/gateway/format.hpp"

void use(std::span<std::uint8_t> out) {
    (void)trama::gateway::encode(trama::gateway::load{}, out);
    (void)trama::daisy::encode({}, trama::daisy::common::ping{}, out);
    (void)trama::daisy::encode({}, trama::gateway::load{}, out);  // wrong
}
