// expect: cannot (convert|initialize).*direction'
#include "trama/daisy/format.hpp"

trama::daisy::dc_motor::set_direction other{.direction = trama::daisy::state::high};  // wrong
