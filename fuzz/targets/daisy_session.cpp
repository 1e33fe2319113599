#include "sessions/daisy.hpp"
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { return trama::fuzz::daisy_session({data, size}, nullptr).run(), 0; }
extern "C" void trama_fuzz_print_wire(const std::uint8_t* data, std::size_t size) {
    trama::fuzz::octets wire;
    trama::fuzz::daisy_session({data, size}, &wire).run();
    trama::fuzz::traits<trama::daisy::format>::print_wire(wire);
}
