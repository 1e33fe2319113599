#pragma once

#include <array>
#include <cstdint>

#include "trama/core/names.hpp"

namespace trama::gateway {

/// Union of a cart's conditions, sent in decimal. Bits without a name are kept. [gateway, "Cart_status"]
enum class cart_status : std::uint16_t {
    none = 0, cart_error = 0x1, hook_error = 0x2, warning = 0x4, paused = 0x8, manual_mode = 0x10, maintenance = 0x20,
    busy = 0x40, ready = 0x80, parking = 0x100, loaded = 0x200, house_keeping = 0x400, shutdown_ready = 0x800,
};
consteval cart_status flags(cart_status) { return static_cast<cart_status>(0x3FFF); }  // the bits of 0..9999
consteval auto names(cart_status) {
    using enum cart_status;
    return std::array{named{cart_error, "cart_error"}, named{hook_error, "hook_error"}, named{warning, "warning"}, named{paused, "paused"},
                      named{manual_mode, "manual_mode"}, named{maintenance, "maintenance"}, named{busy, "busy"}, named{ready, "ready"},
                      named{parking, "parking"}, named{loaded, "loaded"}, named{house_keeping, "house_keeping"}, named{shutdown_ready, "shutdown_ready"}};
}

/// Union of the circuit's failed checks, sent in decimal. Bits without a name are kept. [gateway, "Circuit_check"]
enum class circuit_check : std::uint32_t {
    ok = 0, cart_lost = 0x1, cart_wrong_platform_version = 0x2, cart_wrong_program_version = 0x4, cart_wrong_firmware_version = 0x8,
    cart_wrong_map = 0x10, emergency_armed = 0x20, door_opening = 0x40, all_carts_no_power_frozen = 0x80, cart_emergency = 0x100,
    cart_unlocated = 0x200, cart_traffic_check_failed = 0x400, door_open = 0x800, transport_interrupted = 0x1000, overvoltage = 0x2000,
    undervoltage = 0x4000, overcurrent = 0x8000, cart_wrong_powerboard_version = 0x10000, power_supplies_fail = 0x20000,
    battery_fault = 0x40000, shutting_down = 0x80000, circuit_breaker_48v = 0x100000, all_carts_shutdown_ready = 0x200000,
};
consteval circuit_check flags(circuit_check) { return static_cast<circuit_check>(0xFFFFFF); }  // the bits of 0..9999999
consteval auto names(circuit_check) {
    using enum circuit_check;
    return std::array{named{cart_lost, "cart_lost"}, named{cart_wrong_platform_version, "cart_wrong_platform_version"},
                      named{cart_wrong_program_version, "cart_wrong_program_version"}, named{cart_wrong_firmware_version, "cart_wrong_firmware_version"},
                      named{cart_wrong_map, "cart_wrong_map"}, named{emergency_armed, "emergency_armed"}, named{door_opening, "door_opening"},
                      named{all_carts_no_power_frozen, "all_carts_no_power_frozen"}, named{cart_emergency, "cart_emergency"},
                      named{cart_unlocated, "cart_unlocated"}, named{cart_traffic_check_failed, "cart_traffic_check_failed"},
                      named{door_open, "door_open"}, named{transport_interrupted, "transport_interrupted"}, named{overvoltage, "overvoltage"},
                      named{undervoltage, "undervoltage"}, named{overcurrent, "overcurrent"},
                      named{cart_wrong_powerboard_version, "cart_wrong_powerboard_version"}, named{power_supplies_fail, "power_supplies_fail"},
                      named{battery_fault, "battery_fault"}, named{shutting_down, "shutting_down"}, named{circuit_breaker_48v, "circuit_breaker_48v"},
                      named{all_carts_shutdown_ready, "all_carts_shutdown_ready"}};
}

template <class E>
concept gateway_flags = flag_set<E> && (std::is_same_v<E, cart_status> || std::is_same_v<E, circuit_check>);

template <gateway_flags E>
constexpr E operator|(E a, E b) noexcept { return static_cast<E>(static_cast<std::underlying_type_t<E>>(a) | static_cast<std::underlying_type_t<E>>(b)); }
template <gateway_flags E>
constexpr E operator&(E a, E b) noexcept { return static_cast<E>(static_cast<std::underlying_type_t<E>>(a) & static_cast<std::underlying_type_t<E>>(b)); }
template <gateway_flags E>
constexpr E operator^(E a, E b) noexcept { return static_cast<E>(static_cast<std::underlying_type_t<E>>(a) ^ static_cast<std::underlying_type_t<E>>(b)); }
/// The bits that `a` lacks of those that the columns can hold, named or not: `status &= ~cart_status::busy` clears one bit
/// and keeps all others that can have come. All of them together may be more than the columns hold.
template <gateway_flags E>
constexpr E operator~(E a) noexcept { return a ^ (a | flags(E{})); }
template <gateway_flags E>
constexpr E& operator|=(E& a, E b) noexcept { return a = a | b; }
template <gateway_flags E>
constexpr E& operator&=(E& a, E b) noexcept { return a = a & b; }
template <gateway_flags E>
constexpr E& operator^=(E& a, E b) noexcept { return a = a ^ b; }
/// True when any bit of `bits` is set in `value`.
template <gateway_flags E>
constexpr bool any_of(E value, E bits) noexcept { return (value & bits) != E{}; }

}  // namespace trama::gateway
