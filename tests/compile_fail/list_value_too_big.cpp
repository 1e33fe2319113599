// expect: does not fit|constant expression
#include "trama/daisy/format.hpp"

trama::daisy::distance_sensor::get_value_reply fits{.sensors = 1, .readings = {65'535}};
trama::daisy::distance_sensor::get_value_reply too_big{.sensors = 1, .readings = {65'536}};  // wrong
