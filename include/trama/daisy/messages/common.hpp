#pragma once

#include "trama/core/ascii.hpp"
#include "trama/daisy/message.hpp"

/// Commands that every board has. [daisy §3]
namespace trama::daisy::common {

/// INIT: starts all boards at the same time, and they report to the main controller. [daisy §3.1; T21]
struct init : empty_message<family::common, 0x01> {
    static constexpr std::string_view name = "common.init", section = "3.1";
};

/// RESET: restarts a board. [daisy §3.2; T21]
struct reset : empty_message<family::common, 0x02> {
    static constexpr std::string_view name = "common.reset", section = "3.2";
};

/// PING, answered by an empty reply. [daisy §3.3]
struct ping : empty_message<family::common, 0x03> {
    static constexpr std::string_view name = "common.ping", section = "3.3";
};
using ping_reply = reply_to<ping>;

inline constexpr rule text_size{0, 251, 0, 0, {}, "0..251 bytes"};

/// True when text has no control characters but tab, CR and LF, and nothing beyond ASCII: what a decoder trusts.
constexpr bool is_plain(byte_view text) noexcept {
    if (all_printable(text.bytes().data(), text.size())) return true;
    for (const std::uint8_t c : text.bytes())
        if ((c < 0x20 && c != '\t' && c != '\r' && c != '\n') || c > 0x7E) return false;
    return true;
}

/// What a board answers to `Request`: its description. [daisy §3.1, §3.2]
template <class Request>
struct description_reply {
    byte_view description{};  ///< Text as it comes, 0..251 bytes. After decoding it lives as long as the packet.

    static constexpr daisy::key key = reply_to<Request>::key;
    static constexpr std::string_view name = Request::name, section = Request::section;
    static constexpr fields layout{field<&description_reply::description, wire::rest<wire::print::text, 0, 0, 251>>{"description", text_size, "plain text about the board"}};
    friend constexpr bool operator==(const description_reply&, const description_reply&) = default;

    /// Whether DATA of `n` bytes can be this message; `first` is its first byte or null while that has not come.
    static constexpr bool body_fits(std::size_t n, const std::uint8_t*) noexcept { return n <= 251; }
    /// Whether a decoder takes the content as a sign of being in step.
    constexpr bool evident() const noexcept { return is_plain(description); }
};
using init_reply = description_reply<init>;
using reset_reply = description_reply<reset>;

inline constexpr rule rejected_size{5, 249, 5, 0, {}, "5..249 bytes"};

/// ERROR, the only command without a reply. [daisy §3.4]
struct error {
    std::uint8_t code = 0;          ///< 0: bad CRC; 1: unknown command; others belong to the board.
    byte_view rejected{};           ///< Of code 0: the packet as received, 5..249 bytes [D5]. Lives as long as the packet.
    std::uint8_t expected_crc = 0;  ///< Of code 0: the CRC it should have had.

    constexpr bool is_bad_crc() const noexcept { return code == 0; }

    static constexpr daisy::key key = key_of(family::common, 0x04);
    static constexpr std::string_view name = "common.error", section = "3.4";
    static constexpr fields layout{
        field<&error::code, wire::u8>{"code", {}, "0: bad CRC, 1: unknown command, others belong to the board"},
        field<&error::rejected, wire::rest<wire::print::hex, 1, 5, 249>, &error::is_bad_crc>{"rejected", rejected_size, "code 0 only: the packet as it was received"},
        field<&error::expected_crc, wire::u8, &error::is_bad_crc>{"expected_crc", {}, "code 0 only: the CRC that was expected"},
    };
    friend constexpr bool operator==(const error&, const error&) = default;

    static constexpr bool body_fits(std::size_t n, const std::uint8_t* first) noexcept {
        const bool short_form = n == 1, long_form = n >= 7;
        return first == nullptr ? short_form || long_form : *first == 0 ? long_form : short_form;
    }
    /// A rejected packet whose LEN and expected CRC agree with its bytes.
    constexpr bool evident() const noexcept {
        if (code != 0) return true;
        return rejected[0] + std::size_t{1} == rejected.size() && xor_of(rejected.bytes().first(rejected.size() - 1)) == expected_crc;
    }
};

using messages = message_list<init, init_reply, reset, reset_reply, ping, ping_reply, error>;

}  // namespace trama::daisy::common
