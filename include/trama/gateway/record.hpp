#pragma once

#include "trama/core/ascii.hpp"
#include "trama/gateway/messages.hpp"

namespace trama::gateway {

inline constexpr std::uint8_t stx = 0x02;
inline constexpr std::uint8_t etx = 0x03;
inline constexpr std::size_t type_size = 3;                    ///< Characters of the order type.
inline constexpr std::size_t max_payload = 206;                ///< Of a cart_state.
inline constexpr std::size_t max_record = max_payload + 2;     ///< With STX and ETX.
inline constexpr std::size_t unknown = messages::count;        ///< The index of a record that the document lacks.

/// Facts about each record that the decoder needs, derived from the message list.
struct catalogue {
    static constexpr std::size_t types = 256;
    std::array<std::uint8_t, types> index{};          ///< Message by order type.
    std::array<std::uint8_t, unknown + 1> payload{};  ///< Characters between STX and ETX; 0 of an unknown record.

    consteval catalogue() {
        for (auto& i : index) i = unknown;
        std::size_t at = 0;
        messages::each([&]<class M>() {
            payload[at] = type_size + M::layout.size;
            index[static_cast<std::size_t>(M::key)] = static_cast<std::uint8_t>(at++);
        });
    }
};
inline constexpr catalogue known{};

/// Index in `messages` of an order type, or `unknown`.
constexpr std::size_t index_of(std::uint32_t type) noexcept { return type < catalogue::types ? known.index[type] : unknown; }

/// A record between its delimiters, printable throughout. Views live until the decoder's next call.
class packet {
    // Accessors are always inlined: a call would force the packet, and the decoder's event around it, into memory.
public:
    constexpr packet() = default;
    /// Precondition: `bytes` runs from STX to ETX.
    constexpr packet(std::span<const std::uint8_t> bytes, std::uint32_t type, std::size_t index) noexcept
        : bytes_(bytes), type_(static_cast<std::uint16_t>(type)), index_(static_cast<std::uint8_t>(index)) {}

    struct no_envelope {
        friend constexpr bool operator==(no_envelope, no_envelope) = default;
    };
    /// All of it, STX to ETX; send these to pass the record on unchanged.
    [[gnu::always_inline]] constexpr std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }
    /// The characters between the delimiters, the type included.
    [[gnu::always_inline]] constexpr std::span<const std::uint8_t> payload() const noexcept { return bytes_.size() < 2 ? bytes_ : std::span(bytes_.data() + 1, bytes_.size() - 2); }
    /// The characters behind the type.
    [[gnu::always_inline]] constexpr std::span<const std::uint8_t> body() const noexcept {
        return bytes_.size() < type_size + 2 ? std::span<const std::uint8_t>{} : std::span(bytes_.data() + type_size + 1, bytes_.size() - type_size - 2);
    }
    [[gnu::always_inline]] constexpr no_envelope envelope() const noexcept { return {}; }
    /// The record's type, 0..999, as its first three characters say.
    [[gnu::always_inline]] constexpr std::uint16_t type() const noexcept { return type_; }
    [[gnu::always_inline]] constexpr order_type key() const noexcept { return static_cast<order_type>(type_); }
    /// Position in `messages`, or `unknown`.
    [[gnu::always_inline]] constexpr std::size_t index() const noexcept { return index_; }

private:
    std::span<const std::uint8_t> bytes_{};
    std::uint16_t type_ = 0;
    std::uint8_t index_ = unknown;
};

/// Nothing besides the message travels in a record.
using envelope = packet::no_envelope;

}  // namespace trama::gateway
