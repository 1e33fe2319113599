#pragma once

#include "trama/daisy/messages.hpp"

namespace trama::daisy {

inline constexpr std::size_t unknown = messages::count;  ///< The index of a packet that no table defines.
inline constexpr std::size_t header_size = 4;            ///< LARGO, DESTINO, ORIGEN, COMANDO. [daisy §2]
inline constexpr std::size_t min_packet = 5;             ///< With CRC, without DATO.
inline constexpr std::size_t max_packet = 256;           ///< LARGO is one byte and counts what follows it.

inline constexpr std::uint16_t variable = 0x100;         ///< No LARGO byte has this value.

/// Facts about each message that the decoder needs for every packet, derived from the message list.
struct catalogue {
    /// Message by family (0..5, 6 for battery_controller's second group, 7 for none), response bit, family bit and low nibble.
    std::array<std::uint8_t, 8 * 64> index{};
    std::array<std::uint16_t, unknown + 1> fixed_len{};  ///< LARGO of a fixed message, `variable` of the others.
    std::array<daisy::key, unknown + 1> keys{};
    /// Row of `quick`, times 256, by the groups of a header and its response bit, as `pair_of` picks them out.
    std::array<std::uint16_t, 512> rows{};
    /// By row and command: LARGO of a fixed message, or `variable`, times 128, and the message's index. A row is a group,
    /// or 7 where the groups are not documented.
    std::array<std::uint16_t, 8 * 256> quick{};

    consteval catalogue() {
        for (auto& i : index) i = unknown;
        for (auto& len : fixed_len) len = variable;
        std::size_t at = 0;
        messages::each([&]<class M>() {
            keys[at] = M::key;
            if constexpr (M::layout.fixed) fixed_len[at] = header_size + M::layout.size;
            for (unsigned group = 0; group != 8; ++group)
                if (family_of(M::key) == family::common || family_of(M::key) == family_of(group)) index[slot(group, command_of(M::key))] = static_cast<std::uint8_t>(at);
            ++at;
        });
        static_assert(unknown < 128);
        for (unsigned row = 0; row != 8; ++row)
            for (unsigned command = 0; command != 256; ++command) {
                const unsigned found = (command & 0x30) == 0 && row != 7 ? index[slot(row, command)] : unknown;
                quick[row << 8 | command] = static_cast<std::uint16_t>(unsigned{fixed_len[found]} << 7 | found);
            }
        for (auto& row : rows) row = 7 << 8;
        for (unsigned destination = 0; destination != 7; ++destination)
            for (unsigned source = 0; source != 7; ++source) {
                const std::uint32_t request = destination << 12 | source << 20, response = request | std::uint32_t{response_bit} << 24;
                rows[pair_of(request)] = static_cast<std::uint16_t>((destination != 0 ? destination : source) << 8);
                rows[pair_of(response)] = static_cast<std::uint16_t>((source != 0 ? source : destination) << 8);
            }
    }
    /// Place in `rows` of a header whose four bytes are `head`, first one lowest. The product moves the two groups and
    /// the response bit to the top nine bits; what else it adds up stays below and never carries.
    static constexpr std::size_t pair_of(std::uint32_t head) noexcept {
        constexpr std::uint64_t gather = std::uint64_t{1} << 48 | std::uint64_t{1} << 36 | std::uint64_t{1} << 24;
        return std::uint64_t{head & 0x80F0F000} * gather >> 55;
    }
    /// Place in `index`. All commands of the document have a low nibble and two bits: 0x0n, 0x4n and their responses.
    static constexpr std::size_t slot(unsigned group, unsigned command) noexcept { return group << 6 | (command >> 2 & 0x30) | (command & 15); }
};
inline constexpr catalogue known{};

/// Index in `messages` of `command` between two boards, or `unknown`. [D3]
constexpr std::size_t index_of(unsigned destination, unsigned source, unsigned command) noexcept {
    const unsigned near = (command & response_bit) != 0 ? source >> 4 : destination >> 4;
    const unsigned far = (command & response_bit) != 0 ? destination >> 4 : source >> 4;
    const unsigned group = near != 0 ? near : far;
    const std::size_t at = known.index[catalogue::slot(group < 7 ? group : 7, command)];
    return (command & 0x30) == 0 ? at : unknown;
}

/// True when the groups are the document's, or everyone is called with a common command. [daisy §4]
constexpr bool documented_addresses(unsigned destination, unsigned source, unsigned command) noexcept {
    const bool everyone_called = destination == everyone.octet && (command & family_bit) == 0;
    return source < 0x70 && (destination < 0x70 || everyone_called);
}

template <class M>
using has_variable_length = std::bool_constant<!M::layout.fixed>;
/// The few messages whose LARGO is not fixed; a search among these costs less than a jump into all messages.
using variable_messages = typename filtered<messages, has_variable_length>::type;

/// Calls `f.operator()<M>()` for the message at `index` if its LARGO is not fixed.
constexpr void for_variable(std::size_t index, auto&& f) noexcept {
    const daisy::key key = known.keys[index];
    variable_messages::each([&]<class M>() {
        if (key == M::key) f.template operator()<M>();
    });
}

/// False when the five bytes at `p` are no documented header. True when they may be one.
constexpr bool may_be_documented(const std::uint8_t* p) noexcept {
    const auto head = load_le<std::uint32_t>(p);
    const unsigned found = known.quick[known.rows[catalogue::pair_of(head)] + (head >> 24)];
    const bool fixed = found >> 7 == (head & 0xFF), varies = found >> 7 == variable && (found & 0x7F) != unknown;
    const bool everyone_called = (head & 0x4000FF00) == everyone.octet << 8;
    return fixed || varies || everyone_called;
}

/// Whether the message at `index` can have DATA of `size` bytes; `first` is its first byte, null while that has not come.
constexpr bool body_fits(std::size_t index, std::size_t size, const std::uint8_t* first) noexcept {
    if (known.fixed_len[index] != variable) return size + header_size == known.fixed_len[index];
    bool fits = false;
    for_variable(index, [&]<class M>() { fits = M::body_fits(size, first); });
    return fits;
}

}  // namespace trama::daisy
