// expect: narrowing|cannot be narrowed
#include "trama/daisy/format.hpp"

trama::daisy::dc_motor::set_dc_speed fits{.speed = -32'768};
trama::daisy::dc_motor::set_dc_speed too_fast{.speed = 32'768};  // wrong
