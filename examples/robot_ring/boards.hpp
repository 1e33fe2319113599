#pragma once
// The five boards of the robot: what each does with a request.

#include <array>
#include <cstdint>

#include "trama/daisy/node.hpp"

namespace robot {

namespace daisy = trama::daisy;
using daisy::answer;

struct motor_board {
    static constexpr daisy::address where = daisy::board(1, 0);
    static constexpr const char* description = "DC motor, left wheel";

    answer operator()(const daisy::dc_motor::set_direction& m, daisy::dc_motor::set_direction_reply&) { direction = m.direction; return answer::done; }
    answer operator()(const daisy::dc_motor::set_dc_speed& m, daisy::dc_motor::set_dc_speed_reply&) {
        direction = m.direction;
        speed = m.speed;
        return answer::done;
    }
    answer operator()(const daisy::dc_motor::get_dc_speed&, daisy::dc_motor::get_dc_speed_reply& r) { r = {direction, speed}; return answer::done; }
    answer operator()(const daisy::dc_motor::set_encoder& m, daisy::dc_motor::set_encoder_reply&) { count = m.count; return answer::done; }
    answer operator()(const daisy::dc_motor::get_encoder&, daisy::dc_motor::get_encoder_reply& r) { r.count = count; return answer::done; }
    answer operator()(const daisy::dc_motor::reset_encoder&, daisy::dc_motor::reset_encoder_reply&) { count = 0; return answer::done; }
    answer operator()(const daisy::dc_motor::set_encoder_to_stop& m, daisy::dc_motor::set_encoder_to_stop_reply&) { to_stop = m.count; return answer::done; }
    answer operator()(const daisy::dc_motor::get_encoder_to_stop&, daisy::dc_motor::get_encoder_to_stop_reply& r) { r.count = to_stop; return answer::done; }
    answer operator()(const daisy::dc_motor::dont_stop&, daisy::dc_motor::dont_stop_reply&) { to_stop = 0; return answer::done; }
    answer operator()(const daisy::dc_motor::motor_consumption&, daisy::dc_motor::motor_consumption_reply& r) { r.consumption = 311; return answer::done; }

    daisy::direction direction{};
    std::int16_t speed = 0, to_stop = 0;
    std::int32_t count = 0;
};

struct servo_board {
    static constexpr daisy::address where = daisy::board(2, 0);
    static constexpr const char* description = "Servos of the arm";

    answer operator()(const daisy::servo_motor::set_position& m, daisy::servo_motor::set_position_reply&) { positions[m.servo_id] = m.position; return answer::done; }
    answer operator()(const daisy::servo_motor::set_all_positions& m, daisy::servo_motor::set_all_positions_reply&) { positions = m.positions; return answer::done; }
    answer operator()(const daisy::servo_motor::get_position& m, daisy::servo_motor::get_position_reply& r) { r = {m.servo_id, positions[m.servo_id]}; return answer::done; }
    answer operator()(const daisy::servo_motor::get_all_positions&, daisy::servo_motor::get_all_positions_reply& r) { r.positions = positions; return answer::done; }
    answer operator()(const daisy::servo_motor::get_status&, daisy::servo_motor::get_status_reply& r) { r.switches = 0x15; return answer::done; }
    answer operator()(const daisy::servo_motor::free_all_servos&, daisy::servo_motor::free_all_servos_reply&) { return answer::done; }

    std::array<std::uint8_t, 5> positions{90, 90, 90, 90, 90};
};

struct distance_board {
    static constexpr daisy::address where = daisy::board(3, 0);
    static constexpr const char* description = "Distance sensors, front";

    answer operator()(const daisy::distance_sensor::set_distance_sensors_mask& m, daisy::distance_sensor::set_distance_sensors_mask_reply&) { mask = m.sensors; return answer::done; }
    answer operator()(const daisy::distance_sensor::get_distance_sensors_mask&, daisy::distance_sensor::get_distance_sensors_mask_reply& r) { r.sensors = mask; return answer::done; }
    answer operator()(const daisy::distance_sensor::get_value& m, daisy::distance_sensor::get_value_reply& r) {
        r.sensors = m.sensors & mask;
        for (unsigned i = 0; i != 6; ++i)
            if ((r.sensors >> i & 1) != 0) r.readings.push_back(static_cast<std::uint16_t>(100 + 11 * i));
        return answer::done;
    }

    std::uint8_t mask = 0x3F;
};

struct battery_board {
    static constexpr daisy::address where = daisy::board(4, 0);
    static constexpr const char* description = "Battery controller";

    answer operator()(const daisy::battery_controller::enable&, daisy::battery_controller::enable_reply&) { return answer::done; }
    answer operator()(const daisy::battery_controller::disable&, daisy::battery_controller::disable_reply&) { return answer::done; }
    answer operator()(const daisy::battery_controller::get_battery_value&, daisy::battery_controller::get_battery_value_reply& r) { r.value = 875; return answer::done; }
    answer operator()(const daisy::battery_controller::set_battery_empty_value&, daisy::battery_controller::set_battery_empty_value_reply&) { return answer::done; }
    answer operator()(const daisy::battery_controller::set_full_battery_value&, daisy::battery_controller::set_full_battery_value_reply&) { return answer::done; }
};

struct bin_board {
    static constexpr daisy::address where = daisy::board(5, 0);
    static constexpr const char* description = "Trash bin";

    answer operator()(const daisy::trash_bin::get_trash_bin_value&, daisy::trash_bin::get_trash_bin_value_reply& r) { r.value = 420; return answer::done; }
    answer operator()(const daisy::trash_bin::set_full_bin_value&, daisy::trash_bin::set_full_bin_value_reply&) { return answer::done; }
};

}  // namespace robot
