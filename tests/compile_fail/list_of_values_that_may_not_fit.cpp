// expect: narrowing|cannot be narrowed
#include "trama/daisy/format.hpp"
using trama::daisy::distance_sensor::get_value_reply;

unsigned fits(std::uint16_t measured) { return get_value_reply{.sensors = 1, .readings = {measured}}.readings[0]; }
unsigned might_not(int computed) { return get_value_reply{.sensors = 1, .readings = {computed}}.readings[0]; }  // wrong
