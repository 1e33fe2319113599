// expect: cannot (convert|initialize).*'int'
// An enumerator is not a plain number: an unnamed value has to be asked for with a cast.
#include "trama/daisy/format.hpp"

trama::daisy::dc_motor::set_direction named{.direction = trama::daisy::direction::clockwise};
trama::daisy::dc_motor::set_direction asked_for{.direction = static_cast<trama::daisy::direction>(7)};
trama::daisy::dc_motor::set_direction number{.direction = 1};  // wrong
