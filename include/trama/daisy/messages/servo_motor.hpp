#pragma once

#include "trama/daisy/message.hpp"

/// Servo motor boards, group 2. [daisy §7]
namespace trama::daisy::servo_motor {

inline constexpr rule switch_masks = between(0, 0x7F);  ///< [daisy §7.11]

/// SET POSITION. [daisy §7.1]
struct set_position {
    std::uint8_t servo_id = 0;  ///< 0..4.
    std::uint8_t position = 0;  ///< Degrees, 0..180.

    static constexpr daisy::key key = key_of(family::servo_motor, 0x40);
    static constexpr std::string_view name = "servo_motor.set_position", section = "7.1";
    static constexpr fields layout{
        field<&set_position::servo_id, wire::u8>{"servo_id", servo_ids, "servo"},
        field<&set_position::position, wire::u8>{"position", degrees, "degrees"},
    };
    friend constexpr bool operator==(const set_position&, const set_position&) = default;
};
using set_position_reply = reply_to<set_position>;
/// SET ALL POSITIONS. [daisy §7.2]
struct set_all_positions {
    std::array<std::uint8_t, 5> positions{};  ///< Degrees, 0..180, one for each servo.

    static constexpr daisy::key key = key_of(family::servo_motor, 0x41);
    static constexpr std::string_view name = "servo_motor.set_all_positions", section = "7.2";
    static constexpr fields layout{field<&set_all_positions::positions, wire::repeated<wire::u8, 5>>{"positions", degrees, "degrees, one for each servo"}};
    friend constexpr bool operator==(const set_all_positions&, const set_all_positions&) = default;
};
using set_all_positions_reply = reply_to<set_all_positions>;
/// GET POSITION. [daisy §7.3]
struct get_position {
    std::uint8_t servo_id = 0;  ///< 0..4.

    static constexpr daisy::key key = key_of(family::servo_motor, 0x42);
    static constexpr std::string_view name = "servo_motor.get_position", section = "7.3";
    static constexpr fields layout{field<&get_position::servo_id, wire::u8>{"servo_id", servo_ids, "servo"}};
    friend constexpr bool operator==(const get_position&, const get_position&) = default;
};
/// GET POSITION, reply. [daisy §7.3]
struct get_position_reply {
    std::uint8_t servo_id = 0;  ///< 0..4.
    std::uint8_t position = 0;  ///< Degrees, 0..180.

    static constexpr daisy::key key = reply_to<get_position>::key;
    static constexpr std::string_view name = get_position::name, section = get_position::section;
    static constexpr fields layout{
        field<&get_position_reply::servo_id, wire::u8>{"servo_id", servo_ids, "servo"},
        field<&get_position_reply::position, wire::u8>{"position", degrees, "degrees"},
    };
    friend constexpr bool operator==(const get_position_reply&, const get_position_reply&) = default;
};

/// GET ALL POSITIONS. [daisy §7.4]
struct get_all_positions : empty_message<family::servo_motor, 0x43> {
    static constexpr std::string_view name = "servo_motor.get_all_positions", section = "7.4";
};
/// GET ALL POSITIONS, reply. [daisy §7.4]
struct get_all_positions_reply {
    std::array<std::uint8_t, 5> positions{};  ///< Degrees, 0..180, one for each servo.

    static constexpr daisy::key key = reply_to<get_all_positions>::key;
    static constexpr std::string_view name = get_all_positions::name, section = get_all_positions::section;
    static constexpr fields layout{field<&get_all_positions_reply::positions, wire::repeated<wire::u8, 5>>{"positions", degrees, "degrees, one for each servo"}};
    friend constexpr bool operator==(const get_all_positions_reply&, const get_all_positions_reply&) = default;
};

/// SET SERVO SPEED. [daisy §7.5]
struct set_servo_speed {
    std::uint8_t servo_id = 0;  ///< 0..4.
    std::uint8_t speed = 0;  ///< Degrees per second, 0..180.

    static constexpr daisy::key key = key_of(family::servo_motor, 0x44);
    static constexpr std::string_view name = "servo_motor.set_servo_speed", section = "7.5";
    static constexpr fields layout{
        field<&set_servo_speed::servo_id, wire::u8>{"servo_id", servo_ids, "servo"},
        field<&set_servo_speed::speed, wire::u8>{"speed", degrees, "degrees per second"},
    };
    friend constexpr bool operator==(const set_servo_speed&, const set_servo_speed&) = default;
};
using set_servo_speed_reply = reply_to<set_servo_speed>;
/// SET ALL SPEEDS. [daisy §7.6]
struct set_all_speeds {
    std::array<std::uint8_t, 5> speeds{};  ///< Degrees per second, 0..180, one for each servo.

    static constexpr daisy::key key = key_of(family::servo_motor, 0x45);
    static constexpr std::string_view name = "servo_motor.set_all_speeds", section = "7.6";
    static constexpr fields layout{field<&set_all_speeds::speeds, wire::repeated<wire::u8, 5>>{"speeds", degrees, "degrees per second, one for each servo"}};
    friend constexpr bool operator==(const set_all_speeds&, const set_all_speeds&) = default;
};
using set_all_speeds_reply = reply_to<set_all_speeds>;
/// GET SERVO SPEED. [daisy §7.7]
struct get_servo_speed {
    std::uint8_t servo_id = 0;  ///< 0..4.

    static constexpr daisy::key key = key_of(family::servo_motor, 0x46);
    static constexpr std::string_view name = "servo_motor.get_servo_speed", section = "7.7";
    static constexpr fields layout{field<&get_servo_speed::servo_id, wire::u8>{"servo_id", servo_ids, "servo"}};
    friend constexpr bool operator==(const get_servo_speed&, const get_servo_speed&) = default;
};
/// GET SERVO SPEED, reply. [daisy §7.7]
struct get_servo_speed_reply {
    std::uint8_t servo_id = 0;  ///< 0..4.
    std::uint8_t speed = 0;  ///< Degrees per second, 0..180.

    static constexpr daisy::key key = reply_to<get_servo_speed>::key;
    static constexpr std::string_view name = get_servo_speed::name, section = get_servo_speed::section;
    static constexpr fields layout{
        field<&get_servo_speed_reply::servo_id, wire::u8>{"servo_id", servo_ids, "servo"},
        field<&get_servo_speed_reply::speed, wire::u8>{"speed", degrees, "degrees per second"},
    };
    friend constexpr bool operator==(const get_servo_speed_reply&, const get_servo_speed_reply&) = default;
};

/// GET ALL SPEEDS. [daisy §7.8]
struct get_all_speeds : empty_message<family::servo_motor, 0x47> {
    static constexpr std::string_view name = "servo_motor.get_all_speeds", section = "7.8";
};
/// GET ALL SPEEDS, reply. [daisy §7.8]
struct get_all_speeds_reply {
    std::array<std::uint8_t, 5> speeds{};  ///< Degrees per second, 0..180, one for each servo.

    static constexpr daisy::key key = reply_to<get_all_speeds>::key;
    static constexpr std::string_view name = get_all_speeds::name, section = get_all_speeds::section;
    static constexpr fields layout{field<&get_all_speeds_reply::speeds, wire::repeated<wire::u8, 5>>{"speeds", degrees, "degrees per second, one for each servo"}};
    friend constexpr bool operator==(const get_all_speeds_reply&, const get_all_speeds_reply&) = default;
};

/// FREE SERVO: the servo lets go. [daisy §7.9]
struct free_servo {
    std::uint8_t servo_id = 0;  ///< 0..4.

    static constexpr daisy::key key = key_of(family::servo_motor, 0x48);
    static constexpr std::string_view name = "servo_motor.free_servo", section = "7.9";
    static constexpr fields layout{field<&free_servo::servo_id, wire::u8>{"servo_id", servo_ids, "servo"}};
    friend constexpr bool operator==(const free_servo&, const free_servo&) = default;
};
using free_servo_reply = reply_to<free_servo>;
/// FREE ALL SERVOS. [daisy §7.10]
struct free_all_servos : empty_message<family::servo_motor, 0x49> {
    static constexpr std::string_view name = "servo_motor.free_all_servos", section = "7.10";
};
using free_all_servos_reply = reply_to<free_all_servos>;
/// GET STATUS. [daisy §7.11]
struct get_status : empty_message<family::servo_motor, 0x4A> {
    static constexpr std::string_view name = "servo_motor.get_status", section = "7.11";
};
/// GET STATUS, reply. [daisy §7.11]
struct get_status_reply {
    std::uint8_t switches = 0;  ///< Bit n is the level of switch n, 0..0x7F.

    static constexpr daisy::key key = reply_to<get_status>::key;
    static constexpr std::string_view name = get_status::name, section = get_status::section;
    static constexpr fields layout{field<&get_status_reply::switches, wire::u8>{"switches", switch_masks, "bit n: level of switch n"}};
    friend constexpr bool operator==(const get_status_reply&, const get_status_reply&) = default;
};

/// ALARM ON STATE. [daisy §7.12]
struct alarm_on_state {
    std::uint8_t switch_id = 0;  ///< 0..5.
    daisy::trigger trigger{};

    static constexpr daisy::key key = key_of(family::servo_motor, 0x4B);
    static constexpr std::string_view name = "servo_motor.alarm_on_state", section = "7.12";
    static constexpr fields layout{
        field<&alarm_on_state::switch_id, wire::u8>{"switch_id", switch_ids, "switch"},
        field<&alarm_on_state::trigger, wire::u8>{"trigger", {}, "change that raises the alarm"},
    };
    friend constexpr bool operator==(const alarm_on_state&, const alarm_on_state&) = default;
};
using alarm_on_state_reply = reply_to<alarm_on_state>;
/// SWITCH ALARM, board to main controller. [daisy §7.13; D4]
struct switch_alarm {
    std::uint8_t switch_id = 0;  ///< 0..5.
    daisy::trigger trigger{};
    daisy::state state{};

    static constexpr daisy::key key = key_of(family::servo_motor, 0x4C);
    static constexpr std::string_view name = "servo_motor.switch_alarm", section = "7.13";
    static constexpr fields layout{
        field<&switch_alarm::switch_id, wire::u8>{"switch_id", switch_ids, "switch"},
        field<&switch_alarm::trigger, wire::u8>{"trigger", {}, "change that raises the alarm"},
        field<&switch_alarm::state, wire::u8>{"state", {}, "level of the switch now"},
    };
    friend constexpr bool operator==(const switch_alarm&, const switch_alarm&) = default;
};
using switch_alarm_reply = reply_to<switch_alarm>;

using messages = message_list<
    set_position, set_position_reply, set_all_positions, set_all_positions_reply, get_position, get_position_reply, get_all_positions,
    get_all_positions_reply, set_servo_speed, set_servo_speed_reply, set_all_speeds, set_all_speeds_reply, get_servo_speed,
    get_servo_speed_reply, get_all_speeds, get_all_speeds_reply, free_servo, free_servo_reply, free_all_servos, free_all_servos_reply,
    get_status, get_status_reply, alarm_on_state, alarm_on_state_reply, switch_alarm, switch_alarm_reply>;

}  // namespace trama::daisy::servo_motor
