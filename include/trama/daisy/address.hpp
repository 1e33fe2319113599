#pragma once

#include <array>
#include <cstdint>

#include "trama/core/names.hpp"

namespace trama::daisy {

/// Families of boards; the high nibble of an address names one. [daisy §4]
enum class family : std::uint8_t {
    main_controller,     ///< Group 0. Defines no commands of its own.
    dc_motor,            ///< Group 1.
    servo_motor,         ///< Group 2.
    distance_sensor,     ///< Group 3.
    battery_controller,  ///< Group 4, and group 6 by the document's second example [D2].
    trash_bin,           ///< Group 5.
    common,              ///< Not a group: the commands below 0x40, which every board has.
    none,                ///< Not a group: there is no such family.
};
consteval auto names(family) {
    using enum family;
    return std::array{named{main_controller, "main_controller"}, named{dc_motor, "dc_motor"},
                      named{servo_motor, "servo_motor"},         named{distance_sensor, "distance_sensor"},
                      named{battery_controller, "battery_controller"}, named{trash_bin, "trash_bin"},
                      named{common, "common"},                   named{none, "none"}};
}

/// The family of a group number, 0..15. [daisy §4; D2]
constexpr family family_of(unsigned group) noexcept {
    if (group == 6) return family::battery_controller;
    return group < 6 ? static_cast<family>(group) : family::none;
}

/// Board address: group in the high nibble, board in the low one. [daisy §2.2]
struct address {
    std::uint8_t octet = 0;

    constexpr unsigned group() const noexcept { return octet >> 4; }
    constexpr unsigned id() const noexcept { return octet & 0x0F; }
    /// Every board of the group, or with 0xFF every board.
    constexpr bool broadcast() const noexcept { return id() == 0x0F; }
    friend constexpr bool operator==(address, address) = default;
};
inline constexpr address everyone{0xFF};

/// Address of board `id` (0..14, 15 for all of them) in `group` (0..15).
constexpr address board(unsigned group, unsigned id) noexcept { return {static_cast<std::uint8_t>((group & 15) << 4 | (id & 15))}; }

/// Who a packet goes to and who sent it. [daisy §2.2, §2.3]
struct envelope {
    address destination{};
    address source{};  ///< Id 15 is a violation.
    friend constexpr bool operator==(envelope, envelope) = default;
};

inline constexpr std::uint8_t response_bit = 0x80;  ///< [daisy §3]
inline constexpr std::uint8_t family_bit = 0x40;    ///< Set in the commands that a family defines. [daisy §3; D1]

/// Which family's table defines `command` between two boards. [D3]
constexpr family family_of(envelope e, std::uint8_t command) noexcept {
    if ((command & family_bit) == 0) return family::common;
    const bool response = (command & response_bit) != 0;
    const unsigned board_group = response ? e.source.group() : e.destination.group();
    const unsigned peer_group = response ? e.destination.group() : e.source.group();
    return family_of(board_group != 0 ? board_group : peer_group);
}

/// Identity of a message: the family that defines it, then its command byte. [daisy §3]
enum class key : std::uint16_t {};
constexpr key key_of(family f, unsigned command) noexcept { return static_cast<key>(static_cast<unsigned>(f) << 8 | command); }
constexpr std::uint8_t command_of(key k) noexcept { return static_cast<std::uint8_t>(k); }
constexpr family family_of(key k) noexcept { return static_cast<family>(static_cast<unsigned>(k) >> 8); }

}  // namespace trama::daisy
