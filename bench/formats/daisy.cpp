#include "daisy.hpp"

#include "hostile.hpp"
#include "races.hpp"

namespace trama::bench {

namespace {

using F = daisy::format;

/// Every message of the document: those with fields three times as often as those without, texts and errors seldom.
stream<F> random_mix(std::size_t bytes) {
    std::vector<std::size_t> often;
    std::size_t at = 0;
    daisy::messages::each([&]<class M>() {
        const int weight = !M::layout.fixed && !requires(M m) { m.readings; } ? 1 : M::layout.size == 0 ? 2 : 6;
        for (int i = 0; i != weight; ++i) often.push_back(at);
        ++at;
    });
    return make_stream<F>(bytes, 1, [&](auto& s, dice& d) { append_random(s, often[d.below(often.size())], d); });
}
stream<F> periodic(std::size_t bytes) { return make_stream<F>(bytes, 2, append_poll_cycle); }
/// A poll cycle with alarms and pings in between, as one would record it.
stream<F> session(std::size_t bytes) {
    return make_stream<F>(bytes, 3, [](auto& out, dice& d) {
        append_poll_cycle(out, d);
        for (auto more = d.below(4); more != 0; --more) append_random(out, d.below(daisy::messages::count), d);
    });
}
stream<F> garbage(std::size_t bytes) {
    stream<F> s;
    dice d(5);
    s.data.resize(bytes);
    for (auto& b : s.data) b = static_cast<std::uint8_t>(d.next());
    return s;
}
stream<F> hostile(std::size_t bytes) { return {hostile_daisy(bytes)}; }

}  // namespace

void append_poll_cycle(stream<F>& s, dice& d) {
    const daisy::address main{0};
    const auto exchange = [&]<class Request, class Reply>(daisy::address board, const Request& request, Reply) {
        arena memory;
        append(s, {board, main}, request);
        append(s, {main, board}, random_message<Reply>(d, memory));
    };
    arena memory;
    for (unsigned id = 0; id != 3; ++id) {
        const auto motor = daisy::board(1, id);
        exchange(motor, random_message<daisy::dc_motor::set_dc_speed>(d, memory), daisy::dc_motor::set_dc_speed_reply{});
        exchange(motor, daisy::dc_motor::get_encoder{}, daisy::dc_motor::get_encoder_reply{});
        exchange(motor, daisy::dc_motor::motor_consumption{}, daisy::dc_motor::motor_consumption_reply{});
    }
    exchange(daisy::board(2, 0), random_message<daisy::servo_motor::set_all_positions>(d, memory), daisy::servo_motor::set_all_positions_reply{});
    for (unsigned id = 0; id != 2; ++id) {
        append(s, {daisy::board(3, id), main}, daisy::distance_sensor::get_value{0x0F});
        daisy::distance_sensor::get_value_reply values{0x0F, {}};
        for (int i = 0; i != 4; ++i) (void)values.readings.push_back(static_cast<std::uint16_t>(d.below(1024)));
        append(s, {main, daisy::board(3, id)}, values);
    }
    exchange(daisy::board(4, 0), daisy::battery_controller::get_battery_value{}, daisy::battery_controller::get_battery_value_reply{});
}

void add_daisy(std::vector<entry>& all, const scale& sizes) {
    std::vector<workload<F>> kinds{
        {"random mix", condition::clean, random_mix},
        {"periodic", condition::clean, periodic},
        {"garbage", condition::noise, garbage},
        {"hostile", condition::noise, hostile},
    };
    add_session<F>(kinds, session, 8, 4);  // bytes, about a packet
    add_races<F>(all, sizes, kinds);
    add_daisy_encode(all, sizes);
}

}  // namespace trama::bench
