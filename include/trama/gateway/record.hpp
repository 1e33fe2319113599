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

/// The four bytes at `p`, first one lowest: STX and the type as it is written.
constexpr std::uint32_t start_of(const std::uint8_t* p) noexcept { return load_le<std::uint32_t>(p); }

/// Facts about each record that the decoder needs, derived from the message list.
struct catalogue {
    static constexpr std::size_t types = 256, places = 512;
    struct start {
        std::uint32_t key = 0;      ///< STX and a type as it may be written; 0 where there is none.
        std::uint8_t index = 0;     ///< Message of that type.
        std::uint8_t payload = 0;   ///< Characters between STX and ETX.
        std::uint16_t type = 0;
    };
    std::array<std::uint8_t, types> index{};          ///< Message by order type.
    std::array<std::uint8_t, unknown + 1> payload{};  ///< Characters between STX and ETX; 0 of an unknown record.
    std::uint32_t factor = 0x9E3779B1;                ///< Makes `place` collision-free.
    std::array<start, places> starts{};               ///< Every way to write a known type, at its `place`.

    consteval catalogue() {
        for (auto& i : index) i = unknown;
        std::size_t at = 0;
        messages::each([&]<class M>() {
            payload[at] = type_size + M::layout.size;
            index[static_cast<std::size_t>(M::key)] = static_cast<std::uint8_t>(at++);
        });
        while (!place_all()) factor += 2;
    }
    constexpr std::size_t place(std::uint32_t key) const noexcept { return key * factor >> 23; }
    constexpr const start& find(std::uint32_t key) const noexcept { return starts[place(key)]; }

private:
    /// Writes each known type with leading zeros, with spaces on either side, and with both.
    constexpr bool place_all() noexcept {
        starts = {};
        for (std::size_t type = 0; type != types; ++type) {
            if (index[type] == unknown) continue;
            for (std::size_t from = 0; from != type_size; ++from)
                for (std::size_t to = from + 1; to <= type_size; ++to)
                    if (!place_one(type, from, to)) return false;
        }
        return true;
    }
    /// The digits of `type` in the columns from `from` to `to`, as far as they fit.
    constexpr bool place_one(std::size_t type, std::size_t from, std::size_t to) noexcept {
        std::uint32_t key = 0x20202000U | stx;
        std::size_t rest = type;
        for (std::size_t column = to; column-- != from; rest /= 10) {
            const auto shift = static_cast<unsigned>(8 * (column + 1));
            key = (key & ~(std::uint32_t{0xFF} << shift)) | static_cast<std::uint32_t>('0' + rest % 10) << shift;
        }
        start& s = starts[place(key)];
        if (rest != 0) return true;
        if (s.key != 0) return false;
        s = {key, index[type], payload[index[type]], static_cast<std::uint16_t>(type)};
        return true;
    }
};
inline constexpr catalogue known{};

/// Index in `messages` of an order type, or `unknown`.
constexpr std::size_t index_of(std::uint32_t type) noexcept { return type < catalogue::types ? known.index[type] : unknown; }

/// A record between its delimiters, printable throughout. Views live until the decoder's next call, and no longer than the chunk given to it.
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
