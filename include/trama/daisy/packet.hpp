#pragma once

#include "trama/daisy/catalogue.hpp"

namespace trama::daisy {

/// A packet whose length and CRC were verified: views of its bytes, which live until the decoder's next call, and no longer than the chunk
/// given to it. [daisy §2]
class packet {
    // Accessors are always inlined: a call would force the packet, and the decoder's event around it, into memory.
public:
    constexpr packet() = default;
    /// Precondition: `bytes` is a whole packet with a good CRC and `index` its `index_of`.
    constexpr packet(std::span<const std::uint8_t> bytes, std::size_t index) noexcept : bytes_(bytes), index_(index) {}

    /// All of it, LEN to CRC; send these to pass the packet on unchanged.
    [[gnu::always_inline]] constexpr std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }
    /// DATA.
    [[gnu::always_inline]] constexpr std::span<const std::uint8_t> body() const noexcept { return bytes_.empty() ? bytes_ : std::span(bytes_.data() + header_size, bytes_.size() - min_packet); }
    [[gnu::always_inline]] constexpr daisy::envelope envelope() const noexcept { return {{at(1)}, {at(2)}}; }
    [[gnu::always_inline]] constexpr std::uint8_t command() const noexcept { return at(3); }
    constexpr bool response() const noexcept { return (command() & response_bit) != 0; }
    /// Position in `messages`, or `unknown`.
    [[gnu::always_inline]] constexpr std::size_t index() const noexcept { return index_; }
    /// Of an unknown packet, a key that no message has.
    constexpr daisy::key key() const noexcept { return index_ < unknown ? known.keys[index_] : key_of(family::none, command()); }

private:
    [[gnu::always_inline]] constexpr std::uint8_t at(std::size_t i) const noexcept { return i < bytes_.size() ? bytes_[i] : std::uint8_t{0}; }

    std::span<const std::uint8_t> bytes_{};
    std::size_t index_ = unknown;
};

/// Exclusive or of every byte: the CRC of the bytes before it, 0 over a good packet. [daisy §2.6]
constexpr std::uint8_t checksum(std::span<const std::uint8_t> bytes) noexcept { return xor_of(bytes); }

/// What the first bytes of a packet tell about it.
enum class header : std::uint8_t {
    open,        ///< Undocumented: no table defines it, or the groups are unknown.
    documented,  ///< A documented header.
    unclear,     ///< Too few bytes to tell; nothing speaks against a documented header.
    impossible,  ///< LEN below 4, or one that its command cannot have.
};

/// Judges the bytes from `at` on, up to 5 of them; fewer when no more have come.
template <class Bytes>
constexpr header judge_header(const Bytes& bytes, std::size_t at, std::size_t count) noexcept {
    if (count == 0) return header::unclear;
    const unsigned len = bytes[at];
    if (len < header_size) return header::impossible;
    if (count >= header_size) {
        const unsigned destination = bytes[at + 1], source = bytes[at + 2], command = bytes[at + 3];
        const std::size_t index = index_of(destination, source, command);
        if (index == unknown) return header::open;
        const std::uint8_t first = count > header_size ? bytes[at + 4] : std::uint8_t{0};
        if (!body_fits(index, len - header_size, count > header_size ? &first : nullptr)) return header::impossible;
        return documented_addresses(destination, source, command) ? header::documented : header::open;
    }
    if (count >= 2 && bytes[at + 1] >= 0x70 && bytes[at + 1] != everyone.octet) return header::open;
    if (count >= 3 && bytes[at + 2] >= 0x70) return header::open;
    return header::unclear;
}

}  // namespace trama::daisy
