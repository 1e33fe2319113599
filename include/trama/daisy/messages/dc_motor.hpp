#pragma once

#include "trama/daisy/message.hpp"

/// DC motor boards, group 1. [daisy §6]
namespace trama::daisy::dc_motor {

inline constexpr std::string_view turning_sense = "turning sense";
inline constexpr std::string_view counts_per_second = "encoder counts per second";
inline constexpr std::string_view total_counts = "accumulated encoder counts";
inline constexpr std::string_view counts_left = "encoder counts left until the motor stops";
inline constexpr std::string_view mean_consumption = "motor current, mean of the last second, converter counts";
inline constexpr std::string_view alarming_consumption = "motor current that raised the alarm, converter counts";

/// SET DIRECTION. [daisy §6.1]
struct set_direction {
    daisy::direction direction{};

    static constexpr daisy::key key = key_of(family::dc_motor, 0x40);
    static constexpr std::string_view name = "dc_motor.set_direction", section = "6.1";
    static constexpr fields layout{field<&set_direction::direction, wire::u8>{"direction", {}, turning_sense}};
    friend constexpr bool operator==(const set_direction&, const set_direction&) = default;
};
using set_direction_reply = reply_to<set_direction>;

/// SET DC SPEED. [daisy §6.2]
struct set_dc_speed {
    daisy::direction direction{};
    std::int16_t speed = 0;  ///< Encoder counts per second.

    static constexpr daisy::key key = key_of(family::dc_motor, 0x41);
    static constexpr std::string_view name = "dc_motor.set_dc_speed", section = "6.2";
    static constexpr fields layout{
        field<&set_dc_speed::direction, wire::u8>{"direction", {}, turning_sense},
        field<&set_dc_speed::speed, wire::i16>{"speed", {}, counts_per_second},
    };
    friend constexpr bool operator==(const set_dc_speed&, const set_dc_speed&) = default;
};
using set_dc_speed_reply = reply_to<set_dc_speed>;

/// SET ENCODER. [daisy §6.3]
struct set_encoder {
    std::int32_t count = 0;  ///< Encoder counts.

    static constexpr daisy::key key = key_of(family::dc_motor, 0x42);
    static constexpr std::string_view name = "dc_motor.set_encoder", section = "6.3";
    static constexpr fields layout{field<&set_encoder::count, wire::i32>{"count", {}, total_counts}};
    friend constexpr bool operator==(const set_encoder&, const set_encoder&) = default;
};
using set_encoder_reply = reply_to<set_encoder>;

/// GET ENCODER. [daisy §6.4]
struct get_encoder : empty_message<family::dc_motor, 0x43> {
    static constexpr std::string_view name = "dc_motor.get_encoder", section = "6.4";
};
/// GET ENCODER, reply. [daisy §6.4]
struct get_encoder_reply {
    std::int32_t count = 0;  ///< Encoder counts.

    static constexpr daisy::key key = reply_to<get_encoder>::key;
    static constexpr std::string_view name = get_encoder::name, section = get_encoder::section;
    static constexpr fields layout{field<&get_encoder_reply::count, wire::i32>{"count", {}, total_counts}};
    friend constexpr bool operator==(const get_encoder_reply&, const get_encoder_reply&) = default;
};

/// RESET ENCODER. [daisy §6.5]
struct reset_encoder : empty_message<family::dc_motor, 0x44> {
    static constexpr std::string_view name = "dc_motor.reset_encoder", section = "6.5";
};
using reset_encoder_reply = reply_to<reset_encoder>;

/// SET ENCODER TO STOP. [daisy §6.6]
struct set_encoder_to_stop {
    std::int16_t count = 0;  ///< Encoder counts.

    static constexpr daisy::key key = key_of(family::dc_motor, 0x45);
    static constexpr std::string_view name = "dc_motor.set_encoder_to_stop", section = "6.6";
    static constexpr fields layout{field<&set_encoder_to_stop::count, wire::i16>{"count", {}, counts_left}};
    friend constexpr bool operator==(const set_encoder_to_stop&, const set_encoder_to_stop&) = default;
};
using set_encoder_to_stop_reply = reply_to<set_encoder_to_stop>;

/// GET ENCODER TO STOP. [daisy §6.7]
struct get_encoder_to_stop : empty_message<family::dc_motor, 0x46> {
    static constexpr std::string_view name = "dc_motor.get_encoder_to_stop", section = "6.7";
};
/// GET ENCODER TO STOP, reply. [daisy §6.7]
struct get_encoder_to_stop_reply {
    std::int16_t count = 0;  ///< Encoder counts.

    static constexpr daisy::key key = reply_to<get_encoder_to_stop>::key;
    static constexpr std::string_view name = get_encoder_to_stop::name, section = get_encoder_to_stop::section;
    static constexpr fields layout{field<&get_encoder_to_stop_reply::count, wire::i16>{"count", {}, counts_left}};
    friend constexpr bool operator==(const get_encoder_to_stop_reply&, const get_encoder_to_stop_reply&) = default;
};

/// DONT STOP: ends the count of SET ENCODER TO STOP, the motor goes on. [daisy §6.8]
struct dont_stop : empty_message<family::dc_motor, 0x47> {
    static constexpr std::string_view name = "dc_motor.dont_stop", section = "6.8";
};
using dont_stop_reply = reply_to<dont_stop>;

/// MOTOR CONSUMPTION. [daisy §6.9]
struct motor_consumption : empty_message<family::dc_motor, 0x48> {
    static constexpr std::string_view name = "dc_motor.motor_consumption", section = "6.9";
};
/// MOTOR CONSUMPTION, reply: the mean of the last second. [daisy §6.9]
struct motor_consumption_reply {
    std::uint16_t consumption = 0;  ///< 0..1023.

    static constexpr daisy::key key = reply_to<motor_consumption>::key;
    static constexpr std::string_view name = motor_consumption::name, section = motor_consumption::section;
    static constexpr fields layout{field<&motor_consumption_reply::consumption, wire::u16>{"consumption", adc_range, mean_consumption}};
    friend constexpr bool operator==(const motor_consumption_reply&, const motor_consumption_reply&) = default;
};

/// MOTOR STRESS ALARM, board to main controller. [daisy §6.10]
struct motor_stress_alarm {
    std::uint16_t consumption = 0;  ///< 0..1023.

    static constexpr daisy::key key = key_of(family::dc_motor, 0x49);
    static constexpr std::string_view name = "dc_motor.motor_stress_alarm", section = "6.10";
    static constexpr fields layout{field<&motor_stress_alarm::consumption, wire::u16>{"consumption", adc_range, alarming_consumption}};
    friend constexpr bool operator==(const motor_stress_alarm&, const motor_stress_alarm&) = default;
};
using motor_stress_alarm_reply = reply_to<motor_stress_alarm>;

/// MOTOR SHUT DOWN ALARM, board to main controller: after repeated stress alarms the motor is off. [daisy §6.11]
struct motor_shut_down_alarm {
    std::uint16_t consumption = 0;  ///< 0..1023.

    static constexpr daisy::key key = key_of(family::dc_motor, 0x4A);
    static constexpr std::string_view name = "dc_motor.motor_shut_down_alarm", section = "6.11";
    static constexpr fields layout{field<&motor_shut_down_alarm::consumption, wire::u16>{"consumption", adc_range, alarming_consumption}};
    friend constexpr bool operator==(const motor_shut_down_alarm&, const motor_shut_down_alarm&) = default;
};
using motor_shut_down_alarm_reply = reply_to<motor_shut_down_alarm>;

/// GET DC SPEED. [daisy §6.12]
struct get_dc_speed : empty_message<family::dc_motor, 0x4B> {
    static constexpr std::string_view name = "dc_motor.get_dc_speed", section = "6.12";
};
/// GET DC SPEED, reply. [daisy §6.12]
struct get_dc_speed_reply {
    daisy::direction direction{};
    std::int16_t speed = 0;  ///< Encoder counts per second.

    static constexpr daisy::key key = reply_to<get_dc_speed>::key;
    static constexpr std::string_view name = get_dc_speed::name, section = get_dc_speed::section;
    static constexpr fields layout{
        field<&get_dc_speed_reply::direction, wire::u8>{"direction", {}, turning_sense},
        field<&get_dc_speed_reply::speed, wire::i16>{"speed", {}, counts_per_second},
    };
    friend constexpr bool operator==(const get_dc_speed_reply&, const get_dc_speed_reply&) = default;
};

using messages = message_list<
    set_direction, set_direction_reply, set_dc_speed, set_dc_speed_reply, set_encoder, set_encoder_reply, get_encoder, get_encoder_reply,
    reset_encoder, reset_encoder_reply, set_encoder_to_stop, set_encoder_to_stop_reply, get_encoder_to_stop, get_encoder_to_stop_reply, dont_stop,
    dont_stop_reply, motor_consumption, motor_consumption_reply, motor_stress_alarm, motor_stress_alarm_reply, motor_shut_down_alarm,
    motor_shut_down_alarm_reply, get_dc_speed, get_dc_speed_reply>;

}  // namespace trama::daisy::dc_motor
