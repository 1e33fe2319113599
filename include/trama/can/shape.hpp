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
    /// For one look-up each: a letter's row of `first`, the message by row and DLC & 15, frame lengths by message and place.
    std::array<std::uint8_t, 256> rows{};
    std::array<std::array<std::uint8_t, 16>, 32> first{};
    std::array<std::array<std::uint16_t, 4>, unknown + 1> lengths{};

    bool whole_frames = true;  ///< All frames but a message's last have eight bytes.

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
        for (auto& row : first) row.fill(unknown);
        lengths[unknown].fill(0x100);  // no DLC, not even an impossible one
        for (std::size_t letter = 0; letter != index.size(); ++letter) {
            rows['A' + letter] = static_cast<std::uint8_t>(letter + 1);
            for (std::size_t length = min_first_length; length != index[letter].size(); ++length) first[letter + 1][length] = index[letter][length];
        }
        for (std::size_t m = 0; m != unknown; ++m) {
            for (std::size_t i = 0; i != max_frames; ++i) lengths[m][i] = shapes[m].lengths[i];
            for (std::size_t i = 0; i + 1 < shapes[m].frames; ++i) whole_frames = whole_frames && lengths[m][i] == 8;
        }
    }
};
inline constexpr catalogue known{};
static_assert(known.whole_frames, "the reassembler keeps the frame at place i from byte 8 * i on");

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

/// A message's frames, reassembled. Views live until the reassembler's next call, and no longer than the frames given to it.
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
