#pragma once

#include "trama/daisy/messages.hpp"

namespace trama::daisy {

inline constexpr std::size_t unknown = messages::count;  ///< The index of a packet that no table defines.
inline constexpr std::size_t header_size = 4;            ///< LEN, DESTINATION, SOURCE, COMMAND. [daisy §2]
inline constexpr std::size_t min_packet = 5;             ///< With CRC, without DATA.
inline constexpr std::size_t max_packet = 256;           ///< LEN is one byte and counts what follows it.

inline constexpr std::uint16_t variable = 0x100;         ///< No LEN byte has this value.
inline constexpr std::size_t longest_fixed = 15;         ///< LEN of the longest fixed message, or a little more: 16 bytes hold each.

template <class M>
using has_variable_length = std::bool_constant<!M::layout.fixed>;
/// The few messages whose LEN is not fixed; a search among these costs less than a jump into all messages.
using variable_messages = typename filtered<messages, has_variable_length>::type;

/// Whether DATA of some size, whose first byte is given or null while that has not come, can be a certain message.
using body_test = bool (*)(std::size_t size, const std::uint8_t* first) noexcept;

/// Facts about each message that the decoder needs for every packet, derived from the message list.
struct catalogue {
    /// Message by family (0..5, 6 for battery_controller's second group, 7 for none), response bit, family bit and low nibble.
    std::array<std::uint8_t, 8 * 64> index{};
    std::array<std::uint16_t, unknown + 1> fixed_len{};  ///< LEN of a fixed message, `variable` of the others.
    std::array<std::uint8_t, unknown + 1> variable_at{};      ///< Place among `variable_messages`, their count of the others.
    std::array<bool, unknown + 1> carries_bytes{}, texts{};   ///< Texts and errors; texts.
    std::array<body_test, variable_messages::count + 1> fits{};  ///< By `variable_at`; nothing fits the others.
    std::array<daisy::key, unknown + 1> keys{};
    /// Row of `quick`, times 256, by the groups of a header and its response bit, as `pair_of` picks them out.
    std::array<std::uint16_t, 512> rows{};
    /// By row and command: the message's index times 512; `counted` if it is a list whose first byte tells its length; and
    /// LEN, of a list when it is empty, or `not_sized`. A row is a group, or 7 where the groups are not documented.
    std::array<std::uint16_t, 8 * 256> quick{};
    static constexpr std::uint16_t counted = 0x100;
    static constexpr std::uint8_t not_sized = header_size - 1;  ///< A LEN that no packet has.
    /// From `counted` on: what a list's first byte adds to LEN, or what makes it `not_sized` if it gets too long.
    std::array<std::uint8_t, 2 * counted> more{};
    /// By LEN: what to keep of a packet's first and second eight bytes to fold all of them. Of a packet whose LEN is
    /// `not_sized` only that is kept, so that it never folds to 0.
    std::array<std::uint64_t, longest_fixed + 1> first_half{}, second_half{};

    consteval catalogue() {
        number_messages();
        fill_rows();
        fill_quick();
        for (std::size_t len = 0; len != first_half.size(); ++len) {
            const std::size_t kept = len == not_sized ? 1 : len + 1;
            for (std::size_t i = 0; i != kept; ++i) (i < 8 ? first_half : second_half)[len] |= std::uint64_t{0xFF} << (8 * (i % 8));
        }
    }
    /// What `quick` knows of the header at `p`, whose four bytes are `head`, first one lowest.
    constexpr unsigned find(std::uint32_t head, const std::uint8_t* p) const noexcept { return quick[std::size_t{rows[pair_of(head)]} + p[3]]; }
    /// Index in `messages`, or `unknown`.
    static constexpr std::size_t index_in(unsigned found) noexcept { return found >> 9; }
    /// True if five bytes tell the size of the message at `p`, of which `quick` knows `found`, and LEN is right.
    constexpr bool is_sized(unsigned found, const std::uint8_t* p) const noexcept {
        return static_cast<std::uint8_t>(found + more[std::size_t{found & counted} + p[header_size]]) == p[0];
    }
    /// Exclusive or of a packet for which `is_sized` holds; not 0 if there is no such packet. 16 bytes at `p` are
    /// readable, of which `low` are the first 8.
    constexpr std::uint8_t fold(std::uint64_t low, const std::uint8_t* p, std::size_t len) const noexcept {
        return fold_xor((low & first_half[len]) ^ (load_le<std::uint64_t>(p + 8) & second_half[len]));
    }
    /// Place in `rows` of a header whose four bytes are `head`, first one lowest. The product moves the two groups and
    /// the response bit to the top nine bits; what else it adds up stays below and never carries.
    static constexpr std::size_t pair_of(std::uint32_t head) noexcept {
        constexpr std::uint64_t gather = std::uint64_t{1} << 48 | std::uint64_t{1} << 36 | std::uint64_t{1} << 24;
        return static_cast<std::size_t>(std::uint64_t{head & 0x80F0F000} * gather >> 55);
    }
    /// Place in `index`. All commands of the document have a low nibble and two bits: 0x0n, 0x4n and their responses.
    static constexpr std::size_t slot(unsigned group, unsigned command) noexcept { return group << 6 | (command >> 2 & 0x30) | (command & 15); }

private:
    consteval void number_messages() {
        for (auto& i : index) i = unknown;
        for (auto& len : fixed_len) len = variable;
        for (auto& place : variable_at) place = variable_messages::count;
        fits.back() = [](std::size_t, const std::uint8_t*) noexcept { return false; };
        std::size_t at = 0;
        std::uint8_t varying = 0;
        messages::each([&]<class M>() {
            keys[at] = M::key;
            if constexpr (M::layout.fixed) fixed_len[at] = header_size + M::layout.size;
            else fits[varying] = M::body_fits, variable_at[at] = varying++;
            carries_bytes[at] = daisy::carries_bytes<M>;
            texts[at] = is_text<M>;
            for (unsigned group = 0; group != 8; ++group)
                if (family_of(M::key) == family::common || family_of(M::key) == family_of(group)) index[slot(group, command_of(M::key))] = static_cast<std::uint8_t>(at);
            ++at;
        });
    }
    consteval void fill_rows() {
        for (auto& row : rows) row = 7 << 8;
        for (unsigned destination = 0; destination != 7; ++destination)
            for (unsigned source = 0; source != 7; ++source) {
                const std::uint32_t request = destination << 12 | source << 20, response = request | std::uint32_t{response_bit} << 24;
                rows[pair_of(request)] = static_cast<std::uint16_t>((destination != 0 ? destination : source) << 8);
                rows[pair_of(response)] = static_cast<std::uint16_t>((source != 0 ? source : destination) << 8);
            }
    }
    consteval void fill_quick() {
        static_assert(unknown < 128);
        for (unsigned row = 0; row != 8; ++row)
            for (unsigned command = 0; command != 256; ++command) {
                const unsigned found = (command & 0x30) == 0 && row != 7 ? index[slot(row, command)] : unknown;
                quick[row << 8 | command] = static_cast<std::uint16_t>(found << 9 | sized_len(found));
            }
        for (unsigned first = 0; first != 256; ++first) {
            const std::size_t size = list_size(static_cast<std::uint8_t>(first)), empty = list_size(0);
            more[counted + first] = static_cast<std::uint8_t>(size + header_size <= longest_fixed ? size - empty : not_sized - header_size - empty);
        }
    }
    /// Size of the DATA that each of the lists with this first byte has. Lists of other sizes would need tables of their own.
    static consteval std::size_t list_size(std::uint8_t first) {
        std::size_t size = 1;
        while (!lists_fit(size, first)) ++size;
        return size;
    }
    static consteval bool lists_fit(std::size_t size, std::uint8_t first) {
        bool all = true;
        variable_messages::each([&]<class M>() {
            if constexpr (!daisy::carries_bytes<M>) all = all && M::body_fits(size, &first);
        });
        return all;
    }
    /// What `quick` says of a message.
    consteval unsigned sized_len(std::size_t found) const {
        if (fixed_len[found] != variable) return fixed_len[found];
        return found == unknown || carries_bytes[found] ? unsigned{not_sized} : static_cast<unsigned>(counted | (header_size + list_size(0)));
    }
};
inline constexpr catalogue known{};
static_assert([] {
    bool all = true;
    std::size_t at = 0;
    messages::each([&]<class M>() {
        const unsigned group = family_of(M::key) == family::common ? 0U : static_cast<unsigned>(family_of(M::key));
        all = all && (command_of(M::key) & 0x30) == 0 && known.index[catalogue::slot(group, command_of(M::key))] == at++;
    });
    return all;
}(), "each message has a command, 0x00..0x0F or 0x40..0x4F and their responses, that no other of its family has");

/// Index in `messages` of `command` between two boards, or `unknown`. [D3]
constexpr std::size_t index_of(unsigned destination, unsigned source, unsigned command) noexcept {
    const unsigned board_group = (command & response_bit) != 0 ? source >> 4 : destination >> 4;
    const unsigned peer_group = (command & response_bit) != 0 ? destination >> 4 : source >> 4;
    const unsigned group = board_group != 0 ? board_group : peer_group;
    const std::size_t at = known.index[catalogue::slot(group < 7 ? group : 7, command)];
    return (command & 0x30) == 0 ? at : unknown;
}

/// True when the groups are the document's, or everyone is called with a common command. [daisy §4]
constexpr bool documented_addresses(unsigned destination, unsigned source, unsigned command) noexcept {
    const bool everyone_called = destination == everyone.octet && (command & family_bit) == 0;
    return source < 0x70 && (destination < 0x70 || everyone_called);
}

/// Calls `f.operator()<M>()` for the message at `index` if its LEN is not fixed.
constexpr void for_variable(std::size_t index, auto&& f) noexcept { variable_messages::at(known.variable_at[index], f); }

/// False when the five bytes at `p` are no documented header. True when they may be one.
constexpr bool may_be_documented(const std::uint8_t* p) noexcept {
    const auto head = load_le<std::uint32_t>(p);
    const unsigned found = known.find(head, p);
    const bool everyone_called = (head & 0x7000FF00) == everyone.octet << 8 && p[2] < 0x70;
    const bool varies = known.variable_at[catalogue::index_in(found)] != variable_messages::count;
    return (known.is_sized(found, p) && p[0] != catalogue::not_sized) || varies || everyone_called;
}

/// Whether the message at `index` can have DATA of `size` bytes; `first` is its first byte, null while that has not come.
constexpr bool body_fits(std::size_t index, std::size_t size, const std::uint8_t* first) noexcept {
    if (known.fixed_len[index] != variable) return size + header_size == known.fixed_len[index];
    return known.fits[known.variable_at[index]](size, first);
}

}  // namespace trama::daisy
