#pragma once

#include "trama/daisy/message.hpp"

/// Battery controllers, groups 4 and 6 [D2]. [daisy §9]
namespace trama::daisy::battery_controller {

/// ENABLE: the battery feeds the robot. [daisy §9.1]
struct enable : empty_message<family::battery_controller, 0x40> {
    static constexpr std::string_view name = "battery_controller.enable", section = "9.1";
};
using enable_reply = reply_to<enable>;

/// DISABLE. [daisy §9.2]
struct disable : empty_message<family::battery_controller, 0x41> {
    static constexpr std::string_view name = "battery_controller.disable", section = "9.2";
};
using disable_reply = reply_to<disable>;

/// GET BATTERY VALUE. [daisy §9.3]
struct get_battery_value : empty_message<family::battery_controller, 0x42> {
    static constexpr std::string_view name = "battery_controller.get_battery_value", section = "9.3";
};
/// GET BATTERY VALUE, reply. [daisy §9.3]
struct get_battery_value_reply {
    std::uint16_t value = 0;  ///< 0..1023.

    static constexpr daisy::key key = reply_to<get_battery_value>::key;
    static constexpr std::string_view name = get_battery_value::name, section = get_battery_value::section;
    static constexpr fields layout{field<&get_battery_value_reply::value, wire::u16>{"value", adc_range, "battery voltage, converter counts"}};
    friend constexpr bool operator==(const get_battery_value_reply&, const get_battery_value_reply&) = default;
};

/// BATTERY FULL ALARM, board to main controller. [daisy §9.4]
struct battery_full_alarm : empty_message<family::battery_controller, 0x43> {
    static constexpr std::string_view name = "battery_controller.battery_full_alarm", section = "9.4";
};
using battery_full_alarm_reply = reply_to<battery_full_alarm>;

/// SET BATTERY EMPTY VALUE. [daisy §9.5]
struct set_battery_empty_value {
    std::uint16_t value = 0;  ///< 0..1023.

    static constexpr daisy::key key = key_of(family::battery_controller, 0x44);
    static constexpr std::string_view name = "battery_controller.set_battery_empty_value", section = "9.5";
    static constexpr fields layout{field<&set_battery_empty_value::value, wire::u16>{"value", adc_range, "threshold of battery voltage, converter counts"}};
    friend constexpr bool operator==(const set_battery_empty_value&, const set_battery_empty_value&) = default;
};
using set_battery_empty_value_reply = reply_to<set_battery_empty_value>;

/// BATTERY EMPTY ALARM, board to main controller. [daisy §9.6]
struct battery_empty_alarm {
    std::uint16_t value = 0;  ///< 0..1023.

    static constexpr daisy::key key = key_of(family::battery_controller, 0x45);
    static constexpr std::string_view name = "battery_controller.battery_empty_alarm", section = "9.6";
    static constexpr fields layout{field<&battery_empty_alarm::value, wire::u16>{"value", adc_range, "battery voltage, converter counts"}};
    friend constexpr bool operator==(const battery_empty_alarm&, const battery_empty_alarm&) = default;
};
using battery_empty_alarm_reply = reply_to<battery_empty_alarm>;

/// SET FULL BATTERY VALUE. [daisy §9.7]
struct set_full_battery_value {
    std::uint16_t value = 0;  ///< 0..1023.

    static constexpr daisy::key key = key_of(family::battery_controller, 0x46);
    static constexpr std::string_view name = "battery_controller.set_full_battery_value", section = "9.7";
    static constexpr fields layout{field<&set_full_battery_value::value, wire::u16>{"value", adc_range, "threshold of battery voltage, converter counts"}};
    friend constexpr bool operator==(const set_full_battery_value&, const set_full_battery_value&) = default;
};
using set_full_battery_value_reply = reply_to<set_full_battery_value>;

using messages = message_list<
    enable, enable_reply, disable, disable_reply, get_battery_value, get_battery_value_reply, battery_full_alarm,
    battery_full_alarm_reply, set_battery_empty_value, set_battery_empty_value_reply, battery_empty_alarm, battery_empty_alarm_reply,
    set_full_battery_value, set_full_battery_value_reply>;

}  // namespace trama::daisy::battery_controller
