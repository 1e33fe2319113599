// expect: no match for|invalid operands
#include "trama/daisy/format.hpp"

namespace motor = trama::daisy::dc_motor;
static_assert(motor::set_encoder{} == motor::set_encoder{});
static_assert(motor::set_encoder{} == motor::get_encoder_reply{});  // wrong
