// expect: no matching function
// Where a field lies must not depend on what stands before it.
#include "trama/core/view.hpp"
#include "trama/daisy/format.hpp"

namespace motor = trama::daisy::dc_motor;
namespace common = trama::daisy::common;

void use(const trama::daisy::packet& packet) {
    (void)trama::view_as<motor::get_encoder_reply>(packet);
    (void)trama::view_as<common::error>(packet);  // wrong
}
