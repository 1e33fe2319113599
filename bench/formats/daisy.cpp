#include "daisy.hpp"

#include "limits.hpp"

namespace trama::bench {

namespace {

using F = daisy::format;
using namespace daisy_code;

/// Every message of the document: those with fields three times as often as those without, texts and errors seldom.
shared_stream<F> random_mix(std::size_t bytes) {
    std::vector<std::size_t> often;
    std::size_t at = 0;
    daisy::messages::each([&]<class M>() {
        const int weight = !M::layout.fixed && !requires(M m) { m.readings; } ? 1 : M::layout.size == 0 ? 2 : 6;
        for (int i = 0; i != weight; ++i) often.push_back(at);
        ++at;
    });
    return std::make_shared<stream<F>>(make_stream<F>(bytes, 1, [&](auto& s, dice& d) { append_random(s, often[d.below(often.size())], d); }));
}
shared_stream<F> periodic(std::size_t bytes) { return std::make_shared<stream<F>>(make_stream<F>(bytes, 2, append_poll_cycle)); }
/// A poll cycle with alarms and pings in between, as one would record it; one packet in `one_in` damaged, 0 for none.
shared_stream<F> session(std::size_t bytes, std::uint64_t one_in) {
    auto s = make_stream<F>(bytes, 3, [](auto& out, dice& d) {
        append_poll_cycle(out, d);
        for (auto more = d.below(4); more != 0; --more) append_random(out, d.below(daisy::messages::count), d);
    });
    return std::make_shared<stream<F>>(one_in == 0 ? std::move(s) : damaged(s, one_in, 8, 4));
}
shared_stream<F> garbage(std::size_t bytes) {
    stream<F> s;
    dice d(5);
    s.data.resize(bytes);
    for (auto& b : s.data) b = static_cast<std::uint8_t>(d.next());
    return std::make_shared<stream<F>>(std::move(s));
}
/// What makes a hunting decoder work hardest: headers of the longest texts, one after the other, and none of them intact.
shared_stream<F> hostile(std::size_t bytes) {
    stream<F> s;
    dice d(6);
    while (s.data.size() < bytes) {
        const std::array<std::uint8_t, 4> header{static_cast<std::uint8_t>(250 + d.below(6)), 0x00, static_cast<std::uint8_t>(d.below(0x60)), static_cast<std::uint8_t>(0x81 + d.below(2))};
        s.data.insert(s.data.end(), header.begin(), header.end());
    }
    return std::make_shared<stream<F>>(std::move(s));
}

void add(std::vector<entry>& all, const std::string& workload, std::size_t bytes, const std::string& task, const std::function<void(race&)>& fill) {
    race r{"daisy", workload, size_name(bytes), task, {}};
    all.push_back({r.id(), [r, fill]() mutable { fill(r); return r; }});
}

constexpr auto all_chunks = {std::size_t{0}, std::size_t{65536}, std::size_t{1460}, std::size_t{64}, std::size_t{7}, std::size_t{1}};

void add_framing(std::vector<entry>& all, const std::string& workload, std::size_t bytes, shared_stream<F> (*make)(std::size_t)) {
    add(all, workload, bytes, "framing", [=](race& r) {
        const auto s = make(bytes);
        add_whole<F>(r, s, "LEN walk", role::limit, 1, walk);
        add_memory_limits(r, s->data);
        add_whole<F>(r, s, "state machine", role::baseline, 1, framing_machine);
        add_whole<F>(r, s, "pointers", role::baseline, 1, framing_pointers);
        add_library<F>(r, s, framing<F>, all_chunks);
    });
}
void add_typed(std::vector<entry>& all, const std::string& workload, std::size_t bytes, shared_stream<F> (*make)(std::size_t)) {
    add(all, workload, bytes, "typed", [=](race& r) {
        const auto s = make(bytes);
        add_whole<F>(r, s, "LEN walk", role::limit, not_compared, walk);
        add_whole<F>(r, s, "state machine", role::baseline, 1, typed_machine);
        add_whole<F>(r, s, "pointers", role::baseline, 1, typed_pointers);
        add_library<F>(r, s, typed<F>, all_chunks);
    });
    add(all, workload, bytes, "validated", [=](race& r) {
        const auto s = make(bytes);
        add_whole<F>(r, s, "LEN walk", role::limit, not_compared, walk);
        add_library<F>(r, s, typed<F, true>, {0});
    });
}
/// Streams whose faults cost the library other packets than the hand-written code, which hunts less carefully.
void add_faulty(std::vector<entry>& all, const std::string& workload, std::size_t bytes, const std::function<shared_stream<F>()>& make) {
    add(all, workload, bytes, "framing", [=](race& r) {
        const auto s = make(), clean = random_mix(bytes);
        add_memory_limits(r, s->data);
        add_library<F>(r, s, framing<F>, {0, 1460});
        add_whole<F>(r, clean, "trama, clean random mix", role::limit, not_compared, [](bytes_in in) { return framing<F>(in, 0); });
    });
}

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
    for (const std::size_t bytes : {sizes.large, sizes.small}) {
        add_framing(all, "random mix", bytes, random_mix);
        add_typed(all, "random mix", bytes, random_mix);
        add_typed(all, "periodic", bytes, periodic);
    }
    add(all, "random mix", sizes.large, "two fields by view", [=](race& r) {
        const auto s = random_mix(sizes.large);
        add_whole<F>(r, s, "LEN walk", role::limit, not_compared, walk);
        add_library<F>(r, s, selected<F>, {0});
    });
    add_framing(all, "periodic", sizes.large, periodic);
    for (const auto& [name, one_in] : {std::pair{"session, no damage", 0}, std::pair{"session, 0.1 % damaged", 1000}, std::pair{"session, 1 % damaged", 100}}) {
        const auto rate = static_cast<std::uint64_t>(one_in);
        add_faulty(all, name, sizes.large, [=] { return session(sizes.large, rate); });
    }
    add_faulty(all, "garbage", sizes.large, [=] { return garbage(sizes.large); });
    add_faulty(all, "hostile", sizes.large, [=] { return hostile(sizes.large); });
    add_daisy_encode(all, sizes);
}

}  // namespace trama::bench
