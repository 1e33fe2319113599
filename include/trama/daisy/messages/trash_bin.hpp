#pragma once

#include "trama/daisy/message.hpp"

/// Trash bin boards, group 5. [daisy §10]
namespace trama::daisy::trash_bin {

/// GET TRASH BIN VALUE. [daisy §10.1]
struct get_trash_bin_value : empty_message<family::trash_bin, 0x40> {
    static constexpr std::string_view name = "trash_bin.get_trash_bin_value", section = "10.1";
};
/// GET TRASH BIN VALUE, reply. [daisy §10.1]
struct get_trash_bin_value_reply {
    std::uint16_t value = 0;  ///< 0..1023.

    static constexpr daisy::key key = reply_to<get_trash_bin_value>::key;
    static constexpr std::string_view name = get_trash_bin_value::name, section = get_trash_bin_value::section;
    static constexpr fields layout{field<&get_trash_bin_value_reply::value, wire::u16>{"value", adc_range, "filling level, converter counts"}};
    friend constexpr bool operator==(const get_trash_bin_value_reply&, const get_trash_bin_value_reply&) = default;
};

/// BIN FULL ALARM, board to main controller. [daisy §10.2]
struct bin_full_alarm : empty_message<family::trash_bin, 0x41> {
    static constexpr std::string_view name = "trash_bin.bin_full_alarm", section = "10.2";
};
using bin_full_alarm_reply = reply_to<bin_full_alarm>;

/// SET FULL BIN VALUE. [daisy §10.3]
struct set_full_bin_value {
    std::uint16_t value = 0;  ///< 0..1023.

    static constexpr daisy::key key = key_of(family::trash_bin, 0x42);
    static constexpr std::string_view name = "trash_bin.set_full_bin_value", section = "10.3";
    static constexpr fields layout{field<&set_full_bin_value::value, wire::u16>{"value", adc_range, "threshold of filling level, converter counts"}};
    friend constexpr bool operator==(const set_full_bin_value&, const set_full_bin_value&) = default;
};
using set_full_bin_value_reply = reply_to<set_full_bin_value>;

using messages = message_list<
    get_trash_bin_value, get_trash_bin_value_reply, bin_full_alarm, bin_full_alarm_reply, set_full_bin_value, set_full_bin_value_reply>;

}  // namespace trama::daisy::trash_bin
