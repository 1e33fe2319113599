// The schema-aware mutations of gateway, for all its targets.
#include "formats/gateway.hpp"
#include "mutate.hpp"
#include "mutate_body.hpp"

namespace trama::fuzz {
using format = gateway::format;
template octets random_wire<format>(dice&);
template sample<format> random_sample<format>(dice&);
template std::size_t mutate<format>(std::uint8_t*, std::size_t, std::size_t, unsigned);
template std::size_t cross<format>(std::span<const std::uint8_t>, std::span<const std::uint8_t>, std::uint8_t*, std::size_t, unsigned);
template std::size_t mutate_body<format>(std::uint8_t*, std::size_t, std::size_t, unsigned);
template std::size_t cross_bodies<format>(std::span<const std::uint8_t>, std::span<const std::uint8_t>, std::uint8_t*, std::size_t, unsigned);
template void print_body<format>(std::span<const std::uint8_t>);
}  // namespace trama::fuzz
