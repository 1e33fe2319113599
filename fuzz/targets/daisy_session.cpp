#include "sessions/daisy.hpp"
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { return trama::fuzz::daisy_session({data, size}, false).run(), 0; }
extern "C" void trama_fuzz_print_wire(const std::uint8_t* data, std::size_t size) { trama::fuzz::daisy_session({data, size}, true).run(); }
