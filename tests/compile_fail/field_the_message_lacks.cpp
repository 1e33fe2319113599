// expect: no (non-static )?(data )?member.*count|does not refer to any field
#include "trama/daisy/format.hpp"

trama::daisy::dc_motor::set_encoder has{.count = 1};
trama::daisy::dc_motor::reset_encoder lacks{.count = 1};  // wrong
