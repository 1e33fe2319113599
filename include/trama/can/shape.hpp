#pragma once

#include "trama/can/messages.hpp"

namespace trama::can {

inline constexpr std::size_t unknown = messages::count;  ///< The index of a message that the document lacks.
inline constexpr std::size_t max_frames = 3;             ///< Frames of the longest message.
inline constexpr std::size_t min_first_length = 3;       ///< Every first frame holds node, message_id and letter.

/// Frame lengths of every message, derived from the message list.
struct catalogue {
    struct shape {
        std::uint8_t frames = 0;
        std::array<std::uint8_t, max_frames> lengths{};
    };
    std::array<shape, unknown + 1> shapes{};
    std::array<can::key, unknown + 1> keys{};
    std::array<std::array<std::uint8_t, 9>, 26> index{};  ///< Message by letter, A..Z, and DLC of its first frame.
    std::uint32_t letters = 0;                            ///< Bit n: some message has the letter 'A' + n.

    consteval catalogue() {
        for (auto& row : index) row.fill(unknown);
        std::size_t at = 0;
        messages::each([&]<class M>() {
            static_assert(M::frame_lengths.size() <= max_frames);
            shapes[at].frames = M::frame_lengths.size();
            for (std::size_t i = 0; i != M::frame_lengths.size(); ++i) shapes[at].lengths[i] = M::frame_lengths[i];
            keys[at] = M::key;
            const auto letter = static_cast<std::size_t>(M::key) / 256 - 'A';
            index[letter][static_cast<std::size_t>(M::key) % 256] = static_cast<std::uint8_t>(at++);
            letters |= 1U << letter;
        });
    }
};
inline constexpr catalogue known{};

/// What a frame is as the first one of a message: the message's index, or why it is none.
struct opening {
    errc code;
    std::size_t index;
};
constexpr opening open_message(const frame& first) noexcept {
    if (first.length < min_first_length || first.length > 8) return {errc::bad_length, unknown};
    const unsigned letter = first.data[2] - unsigned{'A'};
    if (letter >= known.index.size() || (known.letters >> letter & 1) == 0) return {errc::unknown_message, unknown};
    const std::size_t index = known.index[letter][first.length];
    return {index == unknown ? errc::bad_length : errc::ok, index};
}

/// A message's frames, reassembled. Views live until the reassembler's next call.
class packet {
    // Accessors are always inlined: a call would force the packet, and the reassembler's event around it, into memory.
public:
    constexpr packet() = default;
    constexpr packet(can::envelope e, std::span<const std::uint8_t> body, std::size_t index) noexcept : envelope_(e), body_(body), index_(index) {}

    [[gnu::always_inline]] constexpr can::envelope envelope() const noexcept { return envelope_; }
    /// The frames' data run together, the letter included.
    [[gnu::always_inline]] constexpr std::span<const std::uint8_t> body() const noexcept { return body_; }
    /// Position in `messages`, or `unknown`.
    [[gnu::always_inline]] constexpr std::size_t index() const noexcept { return index_; }
    [[gnu::always_inline]] constexpr can::key key() const noexcept { return known.keys[index_]; }

private:
    can::envelope envelope_{};
    std::span<const std::uint8_t> body_{};
    std::size_t index_ = unknown;
};

}  // namespace trama::can
