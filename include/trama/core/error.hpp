#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace trama {

/// Why an operation stopped, the same set in every module. `need_more` is not a fault.
enum class errc : std::uint8_t {
    ok,                ///< No error.
    need_more,         ///< Decoder: the chunk is used up; call again with the next one.
    noise,             ///< Bytes that belong to no packet.
    truncated,         ///< A packet that was cut off.
    bad_length,        ///< A length that the format or the message cannot have.
    bad_checksum,      ///< The check byte does not match.
    bad_character,     ///< A byte that the text format does not allow.
    bad_number,        ///< Digits expected, something else found; `error::field` says where.
    unknown_message,   ///< The documents define no such message; the raw packet is delivered.
    incomplete,        ///< A multi-frame message was interrupted.
    timed_out,         ///< A multi-frame message stalled.
    out_of_range,      ///< Encoder: a value that the document or the wire does not allow.
    buffer_too_small,  ///< Encoder: the output cannot hold the packet; nothing was written.
};
inline constexpr std::size_t errc_count = 13;

/// The code's name as it stands in JSON and in the documentation.
constexpr std::string_view name_of(errc code) noexcept {
    constexpr std::array<std::string_view, errc_count> names{
        "ok",         "need_more",       "noise",      "truncated", "bad_length",   "bad_checksum",     "bad_character",
        "bad_number", "unknown_message", "incomplete", "timed_out", "out_of_range", "buffer_too_small",
    };
    const auto at = static_cast<std::size_t>(code);
    return at < names.size() ? names[at] : std::string_view{"?"};
}

/// Names one value of a message by position: `orders[1].level` is field 10, index 1, sub-field 5.
/// `print_path<M>` writes it as that text.
struct field_ref {
    static constexpr std::uint8_t none = 0xFF;
    static constexpr std::uint8_t destination = 0xFE;  ///< The address of a daisy packet, no field of the message.
    static constexpr std::uint8_t source = 0xFD;       ///< Likewise.
    static constexpr std::uint8_t id = 0xFC;           ///< The identifier of a can message's frames, no field either.
    std::uint8_t field = none;  ///< Position in the message's layout.
    std::uint8_t index = none;  ///< Element of an array, or none.
    std::uint8_t sub = none;    ///< Position in the nested structure's layout, or none.

    friend constexpr bool operator==(field_ref, field_ref) = default;
};

/// A failure and the field that caused it, where one did.
struct error {
    errc code{};
    field_ref field{};

    constexpr explicit operator bool() const noexcept { return code != errc::ok; }
    friend constexpr bool operator==(const error&, const error&) = default;
};

/// Either a value or the error that prevented it. Never allocates, never throws.
template <class T>
class [[nodiscard]] result {
public:
    constexpr result(const T& value) noexcept : value_(value) {}
    constexpr result(trama::error e) noexcept : error_(e) { assert(e); }
    constexpr result(errc code) noexcept : result(trama::error{code, {}}) {}

    constexpr explicit operator bool() const noexcept { return !error_; }
    constexpr trama::error error() const noexcept { return error_; }
    constexpr errc code() const noexcept { return error_.code; }
    /// The value. Precondition: there is one. Of a temporary a copy, so that `const auto& m = *decode<M>(p);` is safe.
    constexpr const T& operator*() const& noexcept { assert(*this); return value_; }
    constexpr T operator*() const&& noexcept { assert(*this); return value_; }
    /// Precondition: there is a value. Of a temporary it lasts to the end of the full expression: `decode<M>(p)->x` is
    /// safe, but a reference or pointer that is kept to it is not.
    constexpr const T* operator->() const noexcept { assert(*this); return &value_; }
    constexpr T value_or(const T& other) const noexcept { return *this ? value_ : other; }

    friend constexpr bool operator==(const result&, const result&) = default;

private:
    T value_{};
    trama::error error_{};
};

/// What a decoder has seen since it was made; readable at any time, never reset by `reset()`.
struct counters {
    std::uint64_t packets = 0;                       ///< Packets delivered, unknown ones not included.
    std::uint64_t skipped = 0;                       ///< Units that error events covered, but not unknown packets.
    std::uint64_t foreign = 0;                       ///< Frames of other protocols (can).
    std::array<std::uint64_t, errc_count> errors{};  ///< Error events by code.

    constexpr std::uint64_t count(errc code) const noexcept { return errors[static_cast<std::size_t>(code)]; }
    friend constexpr bool operator==(const counters&, const counters&) = default;
};

}  // namespace trama
