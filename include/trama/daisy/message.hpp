#pragma once

#include "trama/core/wire_format.hpp"
#include "trama/daisy/address.hpp"
#include "trama/daisy/enums.hpp"

namespace trama::daisy {

/// A message without data. [daisy §2.5]
template <family Family, std::uint8_t Command>
struct empty_message {
    static constexpr daisy::key key = key_of(Family, Command);
    static constexpr fields<> layout{};
    friend constexpr bool operator==(const empty_message&, const empty_message&) = default;
};

/// The empty response to `Request`, which is all that most commands answer. [daisy §3]
template <class Request>
struct reply_to {
    static constexpr daisy::key key = key_of(family_of(Request::key), command_of(Request::key) | response_bit);
    static constexpr std::string_view name = Request::name, section = Request::section;
    static constexpr fields<> layout{};
    friend constexpr bool operator==(const reply_to&, const reply_to&) = default;
};

/// True for the messages that carry bytes of any kind and number: texts and errors.
template <has_layout M>
inline constexpr bool carries_bytes = [] {
    bool any = false;
    each_index<M>([&]<std::size_t I>() { any = any || std::is_same_v<typename std::remove_cvref_t<decltype(field_of<M, I>)>::value, byte_view>; });
    return any;
}();

/// True for the messages that are nothing but a text.
template <has_layout M>
inline constexpr bool is_text = requires(M m) { m.description; };

inline constexpr rule adc_range = between(0, 0x3FF);      ///< 10-bit converter counts.
inline constexpr rule servo_ids = between(0, 4);          ///< [daisy §7.1]
inline constexpr rule degrees = between(0, 180);          ///< [daisy §7.1]
inline constexpr rule switch_ids = between(0, 5);         ///< [daisy §7.12]
inline constexpr rule sensor_ids = between(0, 5);         ///< [daisy §8.1]
inline constexpr rule sensor_masks = between(0, 0x3F);    ///< [daisy §8.3]

}  // namespace trama::daisy
