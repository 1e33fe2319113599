// expect: constant expression|not usable in a constant
#include "trama/daisy/format.hpp"

std::uint16_t measured = 512;
int computed = 66'559;
trama::daisy::distance_sensor::get_value_reply fits{.sensors = 1, .readings = {measured}};
trama::daisy::distance_sensor::get_value_reply might_not{.sensors = 1, .readings = {computed}};  // wrong
