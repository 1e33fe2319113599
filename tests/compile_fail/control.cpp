// control
#include <cstdint>
#include <span>

[[nodiscard]] constexpr std::size_t size_of(std::span<const std::uint8_t> octets) noexcept { return octets.size(); }

static_assert(size_of({}) == 0);
