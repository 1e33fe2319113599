#include "capture.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "trama/trama.hpp"

namespace traffic {

namespace {

namespace daisy = trama::daisy;
namespace common = daisy::common;
namespace dc_motor = daisy::dc_motor;
namespace servo = daisy::servo_motor;
namespace distance = daisy::distance_sensor;
namespace battery = daisy::battery_controller;
namespace bin = daisy::trash_bin;

constexpr daisy::address controller = daisy::board(0, 0);
constexpr daisy::address left_motor = daisy::board(1, 0);
constexpr daisy::address right_motor = daisy::board(1, 1);
constexpr daisy::address arm = daisy::board(2, 0);
constexpr daisy::address eyes = daisy::board(3, 0);
constexpr daisy::address power = daisy::board(4, 0);
constexpr daisy::address spare_power = daisy::board(6, 2);  // group 6 by the document's second example [D2]
constexpr daisy::address basket = daisy::board(5, 0);

trama::byte_view octets(std::string_view text, std::array<std::uint8_t, daisy::max_packet>& buffer) {
    std::copy(text.begin(), text.end(), buffer.begin());
    return std::span<const std::uint8_t>(buffer).first(text.size());
}

class ring {
public:
    std::string run();

private:
    using packet = std::array<std::uint8_t, daisy::max_packet>;

    // The bytes of a packet, in `last_`. What the document does not allow is written all the same: boards do.
    template <class M>
    std::span<std::uint8_t> make(daisy::address to, daisy::address from, const M& m) {
        const auto size = daisy::format::encode_unchecked({to, from}, m, last_);
        if (!size) std::abort();
        return std::span(last_).first(*size);
    }
    template <class M>
    void send(daisy::address to, daisy::address from, const M& m) { line_ << make(to, from, m); }
    // A request of the controller and the answer of the board.
    template <class Request, class Reply>
    void ask(daisy::address board, const Request& request, const Reply& reply) {
        send(board, controller, request);
        send(controller, board, reply);
    }
    template <class Request>
    void tell(daisy::address board, const Request& request) { ask(board, request, daisy::reply_to<Request>{}); }
    // An alarm of a board and the controller's acknowledgement.
    template <class Alarm>
    void alarm(daisy::address board, const Alarm& what) {
        send(controller, board, what);
        send(board, controller, daisy::reply_to<Alarm>{});
    }
    void introduce(daisy::address board, std::string_view description) {
        packet text;
        send(controller, board, common::init_reply{octets(description, text)});
    }

    void boot();
    void poll(int cycle);
    void look_around();
    void corrupt_and_repeat();
    void unknown_command();
    void restart_arm();

    numbers random_{2011};
    capture line_;
    packet last_{};
    int left_count_ = 0;
    int right_count_ = 0;
};

void ring::boot() {
    send(daisy::everyone, controller, common::init{});
    introduce(left_motor, "DC motor, left wheel, v1.4");
    introduce(right_motor, "DC motor, right wheel, v1.4");
    introduce(arm, "Servo motors: arm and gripper, v0.9");
    introduce(eyes, "Distance sensors: 5 infrared, 1 ultrasound");
    introduce(power, "Battery controller \"main\"\r\n12 V");
    introduce(spare_power, "Battery controller, spare");
    introduce(basket, "");
    for (const daisy::address motor : {left_motor, right_motor}) {
        tell(motor, dc_motor::reset_encoder{});
        tell(motor, dc_motor::set_dc_speed{daisy::direction::clockwise, 0});
    }
    tell(arm, servo::set_all_speeds{{60, 60, 60, 90, 120}});
    tell(arm, servo::set_all_positions{{90, 45, 135, 0, 180}});
    tell(arm, servo::alarm_on_state{3, daisy::trigger::any_change});
    tell(eyes, distance::set_distance_sensors_mask{0x3F});
    tell(eyes, distance::on_distance_sensor{5});
    tell(power, battery::set_battery_empty_value{612});
    tell(power, battery::enable{});
    tell(basket, bin::set_full_bin_value{900});
}

void ring::look_around() {
    distance::get_value_reply seen{0x3F, {}};
    for (int sensor = 0; sensor < 5; ++sensor) seen.readings.push_back(static_cast<std::uint16_t>(random_.between(80, 1023)));
    seen.readings.push_back(static_cast<std::uint16_t>(random_.between(200, 30100)));
    ask(eyes, distance::get_value{0x3F}, seen);
}

void ring::poll(int cycle) {
    left_count_ += random_.between(110, 130);
    right_count_ -= random_.between(110, 130);
    ask(left_motor, dc_motor::get_encoder{}, dc_motor::get_encoder_reply{left_count_});
    ask(right_motor, dc_motor::get_encoder{}, dc_motor::get_encoder_reply{right_count_});
    look_around();
    if (cycle % 4 == 0) ask(power, battery::get_battery_value{}, battery::get_battery_value_reply{static_cast<std::uint16_t>(830 - cycle)});
    if (cycle % 5 == 0) ask(left_motor, dc_motor::motor_consumption{}, dc_motor::motor_consumption_reply{static_cast<std::uint16_t>(random_.between(180, 420))});
    if (cycle % 7 == 0) ask(basket, bin::get_trash_bin_value{}, bin::get_trash_bin_value_reply{static_cast<std::uint16_t>(100 + 12 * cycle)});
    if (cycle % 9 == 0) ask(arm, servo::get_status{}, servo::get_status_reply{static_cast<std::uint8_t>(random_.between(0, 127))});
    if (cycle % 10 == 0) ask(right_motor, dc_motor::get_dc_speed{}, dc_motor::get_dc_speed_reply{daisy::direction::counter_clockwise, -120});
}

// A reply arrives damaged. The controller sends it back to its source, which repeats it.
void ring::corrupt_and_repeat() {
    const dc_motor::get_encoder_reply reply{left_count_};
    send(left_motor, controller, dc_motor::get_encoder{});
    const std::span<std::uint8_t> sent = make(controller, left_motor, reply);
    packet damaged = last_;
    damaged[5] ^= 0x08;
    const auto rejected = std::span<const std::uint8_t>(damaged).first(sent.size());
    line_ << rejected;
    const std::uint8_t expected = trama::xor_of(rejected.first(rejected.size() - 1));
    send(left_motor, controller, common::error{0, rejected, expected});
    send(controller, left_motor, reply);
}

void ring::unknown_command() {
    std::array<std::uint8_t, 7> request{6, right_motor.octet, controller.octet, 0x5A, 0x01, 0x02, 0};
    request.back() = trama::xor_of(std::span(request).first(6));
    line_ << request;
    send(controller, right_motor, common::error{1});
}

void ring::restart_arm() {
    packet text;
    ask(arm, common::reset{}, common::reset_reply{octets("Servo motors: arm and gripper, v0.9", text)});
    tell(arm, servo::set_position{3, 40});
    ask(arm, servo::get_all_positions{}, servo::get_all_positions_reply{{90, 45, 135, 40, 180}});
}

std::string ring::run() {
    line_.noise(random_, 11);
    boot();
    for (int cycle = 1; cycle <= 60; ++cycle) {
        poll(cycle);
        if (cycle == 4) tell(left_motor, dc_motor::set_dc_speed{daisy::direction::clockwise, 1200});
        if (cycle == 4) tell(right_motor, dc_motor::set_dc_speed{daisy::direction::counter_clockwise, -1200});
        if (cycle == 12) corrupt_and_repeat();
        if (cycle == 17) alarm(right_motor, dc_motor::motor_stress_alarm{871});
        if (cycle == 18) alarm(right_motor, dc_motor::motor_shut_down_alarm{1020});
        if (cycle == 22) unknown_command();
        if (cycle == 27) alarm(arm, servo::switch_alarm{3, daisy::trigger::rising_edge, daisy::state::high});
        if (cycle == 31) line_.noise(random_, 23);
        if (cycle == 36) restart_arm();
        if (cycle == 40) send(controller, left_motor, dc_motor::motor_stress_alarm{1800});  // more than ten bits
        if (cycle == 44) alarm(eyes, distance::switch_alarm{daisy::trigger::falling_edge, daisy::state::low});
        if (cycle == 49) alarm(spare_power, battery::battery_empty_alarm{512});
        if (cycle == 53) alarm(basket, bin::bin_full_alarm{});
        if (cycle == 57) tell(left_motor, dc_motor::set_encoder_to_stop{400});
    }
    tell(power, battery::disable{});
    line_ << make(controller, power, common::ping_reply{}).first(3);  // switched off while it spoke
    return line_.bytes();
}

}  // namespace

std::string robot() { return ring{}.run(); }

}  // namespace traffic
