// expect: narrowing|cannot be narrowed
#include "trama/daisy/format.hpp"
using trama::daisy::distance_sensor::get_value_reply;

unsigned fits() { return get_value_reply{.sensors = 1, .readings = {65'535}}.readings[0]; }
unsigned too_big() { return get_value_reply{.sensors = 1, .readings = {65'536}}.readings[0]; }  // wrong
