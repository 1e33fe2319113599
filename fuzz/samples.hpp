#pragma once
// Messages on the wire and mutations of input, made from the schema. They are costly to compile, so each format's are compiled
// once, in fuzz/mutators/, for all its targets.
#include "traits.hpp"
#include "trama/core/wire_format.hpp"

namespace trama::fuzz {

/// A message on the wire, as input octets; now and then with a value that the document does not allow.
template <wire_format F>
octets random_wire(dice& d);

/// A message without violations that speaks for itself, and the body that a decoder must deliver.
template <wire_format F>
struct sample {
    std::vector<typename F::unit> units;
    octets body;
};
template <wire_format F>
sample<F> random_sample(dice& d);

/// What libFuzzer's custom mutator and crossover do for targets of format `F`.
template <wire_format F>
std::size_t mutate(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);
template <wire_format F>
std::size_t cross(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::uint8_t* out, std::size_t max_size, unsigned seed);

/// The same for targets that take one body, and its explanation.
template <wire_format F>
std::size_t mutate_body(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);
template <wire_format F>
std::size_t cross_bodies(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::uint8_t* out, std::size_t max_size, unsigned seed);
template <wire_format F>
void print_body(std::span<const std::uint8_t> input);

/// With TRAMA_FUZZ_PLAIN in the environment only the engine's own mutations are used: to show what random octets reach.
inline bool plain_octets() {
    static const bool plain = std::getenv("TRAMA_FUZZ_PLAIN") != nullptr;
    return plain;
}

}  // namespace trama::fuzz

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
