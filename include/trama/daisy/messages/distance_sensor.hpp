#pragma once

#include <bit>

#include "trama/daisy/message.hpp"

/// Distance sensor boards, group 3. [daisy §8]
namespace trama::daisy::distance_sensor {

/// ON DISTANCE SENSOR. [daisy §8.1]
struct on_distance_sensor {
    std::uint8_t sensor_id = 0;  ///< 0..5.

    static constexpr daisy::key key = key_of(family::distance_sensor, 0x40);
    static constexpr std::string_view name = "distance_sensor.on_distance_sensor", section = "8.1";
    static constexpr fields layout{field<&on_distance_sensor::sensor_id, wire::u8>{"sensor_id", sensor_ids, "sensor; 5: the board's LED, if it has one"}};
    friend constexpr bool operator==(const on_distance_sensor&, const on_distance_sensor&) = default;
};
using on_distance_sensor_reply = reply_to<on_distance_sensor>;

/// OFF DISTANCE SENSOR. [daisy §8.2]
struct off_distance_sensor {
    std::uint8_t sensor_id = 0;  ///< 0..5.

    static constexpr daisy::key key = key_of(family::distance_sensor, 0x41);
    static constexpr std::string_view name = "distance_sensor.off_distance_sensor", section = "8.2";
    static constexpr fields layout{field<&off_distance_sensor::sensor_id, wire::u8>{"sensor_id", sensor_ids, "sensor; 5: ultrasound sensor or switch"}};
    friend constexpr bool operator==(const off_distance_sensor&, const off_distance_sensor&) = default;
};
using off_distance_sensor_reply = reply_to<off_distance_sensor>;

/// SET DISTANCE SENSORS MASK. [daisy §8.3]
struct set_distance_sensors_mask {
    std::uint8_t sensors = 0;  ///< Bit n stands for sensor n, 0..0x3F.

    static constexpr daisy::key key = key_of(family::distance_sensor, 0x42);
    static constexpr std::string_view name = "distance_sensor.set_distance_sensors_mask", section = "8.3";
    static constexpr fields layout{field<&set_distance_sensors_mask::sensors, wire::u8>{"sensors", sensor_masks, "bit n: sensor n"}};
    friend constexpr bool operator==(const set_distance_sensors_mask&, const set_distance_sensors_mask&) = default;
};
using set_distance_sensors_mask_reply = reply_to<set_distance_sensors_mask>;

/// GET DISTANCE SENSORS MASK. [daisy §8.4]
struct get_distance_sensors_mask : empty_message<family::distance_sensor, 0x43> {
    static constexpr std::string_view name = "distance_sensor.get_distance_sensors_mask", section = "8.4";
};
/// GET DISTANCE SENSORS MASK, reply. [daisy §8.4]
struct get_distance_sensors_mask_reply {
    std::uint8_t sensors = 0;  ///< Bit n stands for sensor n, 0..0x3F.

    static constexpr daisy::key key = reply_to<get_distance_sensors_mask>::key;
    static constexpr std::string_view name = get_distance_sensors_mask::name, section = get_distance_sensors_mask::section;
    static constexpr fields layout{field<&get_distance_sensors_mask_reply::sensors, wire::u8>{"sensors", sensor_masks, "bit n: sensor n"}};
    friend constexpr bool operator==(const get_distance_sensors_mask_reply&, const get_distance_sensors_mask_reply&) = default;
};

inline constexpr rule sensor_readings = between(0, 0x3FF);                                    ///< Sensors 0..4.
inline constexpr rule switch_or_ultrasound{0, 0x7594, 0xFFFF, 0, {}, "0..30100|65535"};     ///< Sensor 5.
inline constexpr rule no_such_sensor{0, -1, -1, 0, {}, "no such sensor"};                    ///< Bits 6 and 7.

/// What the tables say of all readings; `rule_for` gives the rule of each.
inline constexpr rule any_reading{0, 0xFFFF, 0, 0, {}, "0..1023; of sensor 5 0..30100|65535"};

/// What a board answers to `Request`: one reading for each bit of `sensors`, lowest bit first. [daisy §8.5, §8.6]
template <class Request>
struct readings_reply {
    std::uint8_t sensors = 0;                 ///< Bit n stands for sensor n, 0..0x3F.
    bounded_list<std::uint16_t, 8> readings{};  ///< As many as `sensors` has bits: 0..1023; of sensor 5 0..30100, or 0 and 65535 of a switch.

    /// The readings that `sensors` announces.
    constexpr std::size_t expected_count() const noexcept { return static_cast<std::size_t>(std::popcount(sensors)); }
    /// The sensor, 0..7, that the reading at `position` belongs to.
    constexpr unsigned sensor_at(std::size_t position) const noexcept {
        unsigned mask = sensors;
        for (; position != 0; --position) mask &= mask - 1;
        return static_cast<unsigned>(std::countr_zero(mask | 0x100U));
    }
    constexpr const rule* rule_for(field_ref at) const noexcept {
        if (at.field != 1) return nullptr;
        const unsigned sensor = sensor_at(at.index);
        return sensor < 5 ? &sensor_readings : sensor == 5 ? &switch_or_ultrasound : &no_such_sensor;
    }

    static constexpr daisy::key key = key_of(family::distance_sensor, command_of(Request::key) | response_bit);
    static constexpr std::string_view name = Request::name, section = Request::section;
    static constexpr fields layout{
        field<&readings_reply::sensors, wire::u8>{"sensors", sensor_masks, "bit n: sensor n"},
        field<&readings_reply::readings, wire::counted<wire::u16, 8>>{"readings", any_reading, "one for each bit, lowest first"},
    };
    friend constexpr bool operator==(const readings_reply&, const readings_reply&) = default;

    /// Whether DATA of `n` bytes can be this message; `first` is its first byte or null while that has not come.
    static constexpr bool body_fits(std::size_t n, const std::uint8_t* first) noexcept {
        if (first == nullptr) return n % 2 == 1 && n <= 17;
        return n == 1 + 2 * static_cast<std::size_t>(std::popcount(*first));
    }
};

/// GET VALUE: mean values. [daisy §8.5]
struct get_value {
    std::uint8_t sensors = 0;  ///< Bit n stands for sensor n, 0..0x3F.

    static constexpr daisy::key key = key_of(family::distance_sensor, 0x44);
    static constexpr std::string_view name = "distance_sensor.get_value", section = "8.5";
    static constexpr fields layout{field<&get_value::sensors, wire::u8>{"sensors", sensor_masks, "bit n: sensor n"}};
    friend constexpr bool operator==(const get_value&, const get_value&) = default;
};
using get_value_reply = readings_reply<get_value>;

/// GET ONE VALUE: single values, without a mean. [daisy §8.6]
struct get_one_value {
    std::uint8_t sensors = 0;  ///< Bit n stands for sensor n, 0..0x3F.

    static constexpr daisy::key key = key_of(family::distance_sensor, 0x45);
    static constexpr std::string_view name = "distance_sensor.get_one_value", section = "8.6";
    static constexpr fields layout{field<&get_one_value::sensors, wire::u8>{"sensors", sensor_masks, "bit n: sensor n"}};
    friend constexpr bool operator==(const get_one_value&, const get_one_value&) = default;
};
using get_one_value_reply = readings_reply<get_one_value>;

/// ALARM ON STATE, where sensor 5 is a switch. [daisy §8.7]
struct alarm_on_state {
    daisy::trigger trigger{};

    static constexpr daisy::key key = key_of(family::distance_sensor, 0x46);
    static constexpr std::string_view name = "distance_sensor.alarm_on_state", section = "8.7";
    static constexpr fields layout{field<&alarm_on_state::trigger, wire::u8>{"trigger", {}, "change that raises the alarm"}};
    friend constexpr bool operator==(const alarm_on_state&, const alarm_on_state&) = default;
};
using alarm_on_state_reply = reply_to<alarm_on_state>;

/// SWITCH ALARM, board to main controller. [daisy §8.8; D4]
struct switch_alarm {
    daisy::trigger trigger{};
    daisy::state state{};

    static constexpr daisy::key key = key_of(family::distance_sensor, 0x47);
    static constexpr std::string_view name = "distance_sensor.switch_alarm", section = "8.8";
    static constexpr fields layout{
        field<&switch_alarm::trigger, wire::u8>{"trigger", {}, "change that raises the alarm"},
        field<&switch_alarm::state, wire::u8>{"state", {}, "level of the switch now"},
    };
    friend constexpr bool operator==(const switch_alarm&, const switch_alarm&) = default;
};
using switch_alarm_reply = reply_to<switch_alarm>;

using messages = message_list<
    on_distance_sensor, on_distance_sensor_reply, off_distance_sensor, off_distance_sensor_reply, set_distance_sensors_mask,
    set_distance_sensors_mask_reply, get_distance_sensors_mask, get_distance_sensors_mask_reply, get_value, get_value_reply,
    get_one_value, get_one_value_reply, alarm_on_state, alarm_on_state_reply, switch_alarm, switch_alarm_reply>;

}  // namespace trama::daisy::distance_sensor
