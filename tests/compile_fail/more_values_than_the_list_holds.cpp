// expect: no matching function|no matching constructor
#include "trama/daisy/format.hpp"

trama::daisy::distance_sensor::get_value_reply full{255, {1, 2, 3, 4, 5, 6, 7, 8}};
trama::bounded_list<std::uint16_t, 8> over{1, 2, 3, 4, 5, 6, 7, 8, 9};  // wrong
