// expect: read-only|cannot assign
// A packet is a view of bytes whose check was verified.
#include "trama/daisy/format.hpp"

std::uint8_t use(const trama::daisy::packet& packet) {
    packet.bytes()[0] = 0;  // wrong
    return packet.bytes()[0];
}
