#include "formats/gateway.hpp"
#include "harness.hpp"
#include "samples.hpp"
using format = trama::gateway::format;
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { return trama::fuzz::decode_one<format>({data, size}); }
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max, unsigned seed) { return trama::fuzz::mutate_body<format>(data, size, max, seed); }
extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t m, const std::uint8_t* b, std::size_t n, std::uint8_t* out, std::size_t max, unsigned seed) { return trama::fuzz::cross_bodies<format>({a, m}, {b, n}, out, max, seed); }
extern "C" void trama_fuzz_print_wire(const std::uint8_t* data, std::size_t size) { trama::fuzz::print_body<format>({data, size}); }
