// The snippets of docs/systems: they are compiled and run here, and the last test finds each of them in this file.
#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <fstream>
#include <string>
#include <vector>

#include "trama/can/master.hpp"
#include "trama/can/sensor_node.hpp"
#include "trama/daisy/controller.hpp"
#include "trama/daisy/node.hpp"
#include "trama/gateway/client.hpp"
#include "trama/gateway/server.hpp"

namespace {

using namespace trama;

// Stand-ins for what a real program has: a serial port, a clock, an operating system's queue, a CAN controller, a socket.
std::uint64_t time_now = 1000000;  // far from 0, the time of a frame that nobody has stamped
std::uint64_t milliseconds() { return time_now; }
struct fake_port {
    std::deque<std::uint8_t> in;
    std::vector<std::uint8_t> out;
    int turns = 3;
};
std::size_t read_some(fake_port& p, std::span<std::uint8_t> to) {
    std::size_t n = 0;
    for (; n != to.size() && !p.in.empty(); p.in.pop_front()) to[n++] = p.in.front();
    return n;
}
void write_all(fake_port& p, std::span<const std::uint8_t> bytes) { p.out.insert(p.out.end(), bytes.begin(), bytes.end()); }
bool wait_for(fake_port& p, int) { return p.turns-- > 0; }
/// A task's queue; the task is told to stop when it has run dry.
struct fake_queue {
    std::deque<std::uint8_t> bytes;
    std::atomic<bool>& running;
};
bool queue_receive(fake_queue& q, std::uint8_t& b, int) {
    if (q.bytes.empty()) {
        q.running = false;
        return false;
    }
    b = q.bytes.front();
    q.bytes.pop_front();
    return true;
}
struct fake_can {
    std::deque<can::frame> in;
    std::vector<can::frame> out;
    int turns = 5;
    std::size_t room = 100;
    bool send(const can::frame& f) {
        if (out.size() >= room) return false;
        out.push_back(f);
        return true;
    }
};
void store(int, std::uint8_t) {}
int alarms = 0;
void on_alarm(daisy::address, const daisy::packet&) { ++alarms; }
void lights(bool) {}

namespace motor_node {

struct motor {
    std::int32_t count = 0;

    daisy::answer operator()(const daisy::dc_motor::get_encoder&, daisy::dc_motor::get_encoder_reply& reply) {
        reply.count = count;
        return daisy::answer::done;
    }
    daisy::answer operator()(const daisy::dc_motor::set_encoder& request, daisy::dc_motor::set_encoder_reply&) {
        count = request.count;
        return daisy::answer::done;
    }
};

template <class Port>
void run_board(Port& port) {
    motor device;
    daisy::node<> node(daisy::board(1, 0), "left wheel");
    std::array<std::uint8_t, 64> in{};
    std::array<std::uint8_t, daisy::node<>::max_output> out{};
    while (wait_for(port, 10)) {
        std::span<const std::uint8_t> rest(in.data(), read_some(port, in));
        for (;;) {
            const auto event = node.next(rest, milliseconds(), out, device);
            write_all(port, std::span(out).first(event.written));
            if (event.news == daisy::node_news::need_more) break;
        }
    }
}

template <class Queue, class Port>
void board_task(Queue& received, Port& port, const std::atomic<bool>& running) {
    motor device;
    daisy::node<> node(daisy::board(1, 0), "left wheel");
    std::array<std::uint8_t, daisy::node<>::max_output> out{};
    while (running) {
        std::uint8_t byte = 0;
        const bool came = queue_receive(received, byte, 5);
        std::span<const std::uint8_t> rest(&byte, came ? 1 : 0);
        daisy::node_event event{};
        do {
            event = node.next(rest, milliseconds(), out, device);
            write_all(port, std::span(out).first(event.written));
        } while (event.news != daisy::node_news::need_more);
    }
}

}  // namespace motor_node

namespace interrupts {

/// One writer, the interrupt; one reader, the main loop.
class byte_ring {
public:
    void put(std::uint8_t byte) {
        const unsigned at = head_.load(std::memory_order_relaxed);
        if (at - tail_.load(std::memory_order_acquire) == bytes_.size()) return;  // full: a lost byte is a fault like any other
        bytes_[at % bytes_.size()] = byte;
        head_.store(at + 1, std::memory_order_release);
    }
    std::size_t take(std::span<std::uint8_t> to) {
        const unsigned head = head_.load(std::memory_order_acquire);
        unsigned at = tail_.load(std::memory_order_relaxed);
        std::size_t n = 0;
        for (; n != to.size() && at != head; ++at) to[n++] = bytes_[at % bytes_.size()];
        tail_.store(at, std::memory_order_release);
        return n;
    }

private:
    std::array<std::uint8_t, 256> bytes_{};
    std::atomic<unsigned> head_{0}, tail_{0};
};

byte_ring received;

void on_receive_interrupt(std::uint8_t data_register) { received.put(data_register); }

}  // namespace interrupts

template <class Port>
bool read_the_encoder(Port& port, daisy::controller<>& controller, std::int32_t& count) {
    constexpr daisy::address wheel = daisy::board(1, 0);
    constexpr std::uint8_t command = daisy::command_of(daisy::dc_motor::get_encoder::key);
    std::array<std::uint8_t, 64> in{};
    std::array<std::uint8_t, daisy::controller<>::max_output> out{};
    const auto size = controller.request(wheel, daisy::dc_motor::get_encoder{}, milliseconds(), out);
    if (!size) return false;  // one like it is under way
    write_all(port, std::span(out).first(*size));
    while (wait_for(port, 10)) {
        std::span<const std::uint8_t> rest(in.data(), read_some(port, in));
        for (;;) {
            const auto event = controller.next(rest, milliseconds(), out);
            write_all(port, std::span(out).first(event.written));
            if (event.news == daisy::controller_news::need_more) break;
            if (event.news == daisy::controller_news::alarm && !event.again) on_alarm(event.peer, event.packet);
            if (event.peer != wheel || event.command != command) continue;  // about something else
            using enum daisy::controller_news;
            if (event.news == failed || event.news == absent || event.news == refused) return false;
            if (const auto reply = decode<daisy::dc_motor::get_encoder_reply>(event.packet)) {
                count = reply->count;
                return true;
            }
        }
    }
    return false;
}

template <class Port>
void report_stress(Port& port, daisy::node<>& node, std::uint16_t consumption) {
    std::array<std::uint8_t, daisy::max_packet> out{};
    const auto size = node.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{consumption}, milliseconds(), out);
    if (size) write_all(port, std::span(out).first(*size));  // none if the value is out of range, or an alarm of this command still waits
}

template <class Controller>
void run_master(Controller& bus, can::master<>& master) {
    while (bus.turns-- > 0) {
        std::array<can::frame, 16> in{};
        std::size_t n = 0;
        for (; n != in.size() && !bus.in.empty(); bus.in.pop_front()) {
            in[n] = bus.in.front();
            in[n++].time = milliseconds();
        }
        std::span<const can::frame> rest(in.data(), n);
        for (;;) {
            const auto event = master.next(rest, milliseconds());
            if (event.news == can::master_news::need_more) break;
            if (const auto m = decode<can::sensor_readings>(event.packet); m && event.news == can::master_news::answered)
                for (std::size_t i = 0; i != m->sensor_count; ++i) store(m->readings[i].sensor, m->readings[i].value);
        }
        while (const can::frame* next = master.front()) {
            if (!bus.send(*next)) break;  // no free mailbox: try again later
            master.sent(milliseconds());
        }
    }
}

/// Reads node 1 every second; its actuator 0 is to be on.
bool switch_on(can::master<>& master) {
    if (!master.poll(1)) return false;                            // as many nodes as it can poll already
    return bool(master.request(can::set_actuator{1, 0, 0, 1}));   // node, number (put in by the master), actuator, state
}

struct greenhouse_bed {
    std::uint8_t lamp = 0;

    std::uint8_t read(std::uint8_t sensor) { return sensor == 0 ? 118 : 19; }
    bool set(std::uint8_t actuator, std::uint8_t state) {
        if (actuator != 0) return false;
        lamp = state;
        lights(lamp != 0);
        return true;
    }
    bool get(std::uint8_t actuator, std::uint8_t& state) {
        state = lamp;
        return actuator == 0;
    }
};

can::sensor_node<2> node(1, can::master_1, {0, 1});
greenhouse_bed bed;

/// On a frame received; also every few milliseconds with none, so that partial messages time out.
template <class Controller>
void on_frame(Controller& bus, std::span<can::frame> received) {
    for (can::frame& f : received) f.time = milliseconds();  // else its message times out
    std::span<const can::frame> rest = received;
    while (node.next(rest, milliseconds(), bed).news != can::sensor_node_news::need_more) {}
    if (const can::frame* next = node.front())
        if (bus.send(*next)) node.sent();
}
/// On a frame sent: the one behind it may go.
template <class Controller>
void on_transmitted(Controller& bus) {
    if (const can::frame* next = node.front())
        if (bus.send(*next)) node.sent();
}

template <class Socket>
void order_a_load(Socket& socket, gateway::client<>& client, std::string& told) {
    std::array<std::uint8_t, gateway::max_record> out{};
    gateway::load order{};
    order.cart_id = 1;
    order.station_id = 12;
    order.cargo_id = "box 7";
    if (const auto size = client.send(order, milliseconds(), out)) write_all(socket, std::span(out).first(*size));

    std::array<std::uint8_t, 4096> in{};
    while (wait_for(socket, 20)) {
        std::span<const std::uint8_t> rest(in.data(), read_some(socket, in));
        for (;;) {
            const auto event = client.next(rest, milliseconds());
            if (event.news == gateway::client_news::need_more) break;
            if (event.news == gateway::client_news::accepted)
                if (const auto ack = decode<gateway::transit_ack>(event.packet)) told = ack->transit_id.view();
            if (event.news == gateway::client_news::refused)
                if (const auto no = decode<gateway::nack>(event.packet)) told = no->error_message.view();
        }
    }
}

void set_up(gateway::server<16>& server) {
    server.carts().add(1);  // orders for carts that were not added are refused
    gateway::circuit_state circuit{};
    circuit.circuit_voltage = 482;  // tenths: 48.2 V
    circuit.working_carts = 1;
    circuit.target_mode = circuit.mode = gateway::circuit_mode::automatic;
    server.set_circuit(circuit);
}
/// The cart's transit under way has come to `phase`, the cart to the segment that ends at `end_node`.
void on_progress(gateway::server<16>& server, std::uint32_t cart_id, gateway::transit_phase phase, std::uint32_t end_node) {
    gateway::cart* cart = server.carts().find(cart_id);
    if (cart == nullptr) return;
    cart->slots.advance(phase);  // no transit ends by itself
    cart->state.end_node = end_node;
    cart->changed = true;  // `poll` sends the new state
}

struct house_rules {
    std::string_view operator()(const gateway::load& order, const gateway::cart*) const { return order.station_id > 400 ? "no such station" : ""; }
    std::string_view operator()(const auto&, const gateway::cart*) const { return {}; }  // all other orders
};

template <class Socket>
void serve(Socket& socket, gateway::server<16>& server) {
    const auto session = server.connect();  // closes nothing: hang up on the connection before
    std::array<std::uint8_t, 4096> in{};
    std::array<std::uint8_t, gateway::max_record> out{};
    while (wait_for(socket, 20)) {
        std::span<const std::uint8_t> rest(in.data(), read_some(socket, in));
        for (;;) {
            const auto event = server.next(session, rest, milliseconds(), out);
            write_all(socket, std::span(out).first(event.written));
            if (event.news == gateway::server_news::need_more) break;
        }
        while (const std::size_t size = server.poll(out)) write_all(socket, std::span(out).first(size));
    }
    server.disconnect(session);
}

}  // namespace

TEST(driving, a_board_in_an_event_loop_and_in_a_task) {
    daisy::controller<> controller;
    fake_port line;
    std::int32_t count = -1;
    EXPECT_FALSE(read_the_encoder(line, controller, count));
    fake_port board;
    board.in.assign(line.out.begin(), line.out.end());
    motor_node::run_board(board);
    ASSERT_EQ(board.out.size(), 9U);

    std::atomic<bool> running = true;
    fake_queue received{{line.out.begin(), line.out.end()}, running};
    fake_port task;
    motor_node::board_task(received, task, running);
    EXPECT_EQ(task.out, board.out);

    for (const std::uint8_t b : line.out) interrupts::on_receive_interrupt(b);
    std::array<std::uint8_t, 16> bytes{};
    const std::size_t n = interrupts::received.take(bytes);
    EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n)), line.out);

    controller = daisy::controller<>{};
    fake_port answered;
    answered.in.assign(board.out.begin(), board.out.end());
    EXPECT_TRUE(read_the_encoder(answered, controller, count));
    EXPECT_EQ(count, 0);
}

TEST(driving, a_request_ends_at_once_where_no_board_is_and_where_it_is_refused) {
    daisy::controller<> controller;
    std::int32_t count = -1;
    fake_port line;
    EXPECT_FALSE(read_the_encoder(line, controller, count));
    EXPECT_EQ(line.turns, -1);

    controller = daisy::controller<>{};
    fake_port round;  // the request comes back
    round.in.assign(line.out.begin(), line.out.end());
    EXPECT_FALSE(read_the_encoder(round, controller, count));
    EXPECT_EQ(round.turns, 2);

    controller = daisy::controller<>{};
    fake_port refused;
    std::array<std::uint8_t, daisy::max_packet> error{};
    const auto size = daisy::encode({daisy::board(0, 0), daisy::board(1, 0)}, daisy::common::error{daisy::unknown_command_code, {}, 0}, error);
    refused.in.assign(error.begin(), error.begin() + static_cast<std::ptrdiff_t>(size.value_or(0)));
    EXPECT_FALSE(read_the_encoder(refused, controller, count));
    EXPECT_EQ(refused.turns, 2);
    EXPECT_EQ(count, -1);
}

TEST(driving, an_alarm_that_comes_while_a_reply_is_awaited_is_handled) {
    daisy::node<> board(daisy::board(1, 0), "left wheel");
    daisy::controller<> controller;
    fake_port line;
    report_stress(line, board, 0x3FF);
    fake_port alarm;
    alarm.in.assign(line.out.begin(), line.out.end());
    std::int32_t count = -1;
    alarms = 0;
    EXPECT_FALSE(read_the_encoder(alarm, controller, count));
    EXPECT_EQ(alarms, 1);
}

TEST(driving, an_alarm_is_sent_once_while_it_waits) {
    daisy::node<> board(daisy::board(1, 0), "left wheel");
    fake_port line;
    report_stress(line, board, 0x400);
    EXPECT_TRUE(line.out.empty());
    report_stress(line, board, 0x3FF);
    EXPECT_EQ(line.out.size(), 7U);
    report_stress(line, board, 0x3FE);
    EXPECT_EQ(line.out.size(), 7U);
    EXPECT_EQ(board.in_flight(), 1U);
}

TEST(driving, a_byte_ring_keeps_order_and_loses_what_does_not_fit) {
    interrupts::byte_ring ring;
    for (int round = 0; round != 3; ++round) {
        for (int i = 0; i != 300; ++i) ring.put(static_cast<std::uint8_t>(i));
        std::array<std::uint8_t, 300> out{};
        ASSERT_EQ(ring.take(out), 256U);
        for (int i = 0; i != 256; ++i) ASSERT_EQ(out[static_cast<std::size_t>(i)], i);
    }
}

TEST(driving, a_master_that_polls_and_is_asked) {
    can::master<> master(can::master_1);
    EXPECT_TRUE(switch_on(master));
    for (std::uint8_t n = 2; n <= 8; ++n) EXPECT_TRUE(master.poll(n));
    EXPECT_TRUE(switch_on(master)) << "polled already";
    EXPECT_FALSE(master.poll(9));
    EXPECT_EQ(master.waiting(), 2U);
}

TEST(driving, a_master_and_a_node) {
    can::master<> master(can::master_1);
    master.poll(1);
    fake_can bus;
    run_master(bus, master);
    ASSERT_EQ(bus.out.size(), 1U);
    fake_can other;
    on_frame(other, bus.out);
    on_transmitted(other);
    ASSERT_EQ(other.out.size(), 2U);
    bus.in.assign(other.out.begin(), other.out.end());
    bus.turns = 3;
    run_master(bus, master);
    EXPECT_EQ(master.quality().round_trip.count, 1U);

    can::define_function wanted{};
    wanted.node = 1;
    wanted.function = can::function::continuous_all;
    wanted.message_id = master.request(wanted).value_or(0);
    bus.out.clear();
    bus.turns = 1;
    run_master(bus, master);
    ASSERT_EQ(bus.out.size(), 3U);
    other.out.clear();
    for (can::frame& f : bus.out) {  // one frame at a time, as an interrupt brings them
        time_now += 20;
        on_frame(other, {&f, 1});
        on_frame(other, {});
    }
    on_transmitted(other);
    on_transmitted(other);
    EXPECT_EQ(node.function_in_force(), wanted);
    bus.in.assign(other.out.begin(), other.out.end());
    bus.turns = 1;
    run_master(bus, master);
    EXPECT_EQ(master.quality().round_trip.count, 2U);
}

TEST(driving, a_mailbox_that_takes_one_frame_at_a_time) {
    can::master<> master(can::master_2);
    can::define_function wanted{};
    wanted.node = 3;
    wanted.function = can::function::continuous_all;
    wanted.message_id = master.request(wanted).value_or(1);
    std::array<can::frame, 3> expected{};
    ASSERT_TRUE(can::encode({can::master_2}, wanted, expected));
    fake_can bus;
    for (bus.room = 0; bus.room != 4; ++bus.room) {
        bus.turns = 2;
        run_master(bus, master);
        ASSERT_EQ(bus.out.size(), bus.room);
    }
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), bus.out.begin(), bus.out.end()));
}

TEST(driving, a_client_and_a_server) {
    gateway::client<> client(1000);
    gateway::server<16> server;
    set_up(server);
    fake_port up;
    std::string told;
    order_a_load(up, client, told);
    fake_port gate;
    gate.in.assign(up.out.begin(), up.out.end());
    serve(gate, server);
    fake_port down;
    down.in.assign(gate.out.begin(), gate.out.end());
    gateway::client<> again(1000);
    order_a_load(down, again, told);
    EXPECT_EQ(told, "T000000001");

    on_progress(server, 1, gateway::transit_phase::transit_done, 12);
    EXPECT_EQ(server.carts()[0].report(server.circuit().mode).cart_phase, gateway::cart_phase::transit_done);
    on_progress(server, 2, gateway::transit_phase::transit_done, 12);
    (void)server.connect();
    std::array<std::uint8_t, gateway::max_record> out{};
    int states = 0;
    while (const std::size_t size = server.poll(out)) {
        std::span<const std::uint8_t> record = std::span(out).first(size);
        gateway::decoder decoder;
        const auto event = decoder.next(record);
        if (const auto cart = decode<gateway::cart_state>(event.packet)) { EXPECT_EQ(cart->end_node, 12U); }
        if (const auto circuit = decode<gateway::circuit_state>(event.packet)) { EXPECT_EQ(circuit->circuit_voltage, 482); }
        ++states;
    }
    EXPECT_EQ(states, 2);
}

TEST(driving, a_server_with_rules_of_its_own) {
    gateway::server<16> server;
    set_up(server);
    const auto session = server.connect();
    for (const std::uint32_t station : {400U, 401U}) {
        std::array<std::uint8_t, gateway::max_record> order{}, reply{};
        gateway::load m{};
        m.cart_id = 1;
        m.station_id = station;
        std::span<const std::uint8_t> rest = std::span(order).first(gateway::encode(m, order).value_or(0));
        const auto event = server.next(session, rest, milliseconds(), reply, house_rules{});
        EXPECT_EQ(event.news, station == 400 ? gateway::server_news::accepted : gateway::server_news::refused);
        EXPECT_EQ(event.reason, station == 400 ? "" : "no such station");
    }
}

TEST(systems_docs, hold_no_snippet_that_is_not_compiled_here) {
    const auto squeezed = [](const std::string& text) {
        std::string out;
        for (const char c : text)
            if (c != ' ' && c != '\n') out += c;
        return out;
    };
    std::ifstream file("tests/systems/driving_test.cpp");
    ASSERT_TRUE(file) << "run from the top of the repository";
    const std::string here = squeezed(std::string(std::istreambuf_iterator<char>(file), {}));
    int snippets = 0;
    for (const char* page : {"daisy", "can", "gateway"}) {
        std::ifstream doc("docs/systems/" + std::string(page) + ".md");
        ASSERT_TRUE(doc) << page;
        std::string snippet;
        bool inside = false;
        for (std::string line; std::getline(doc, line);) {
            if (line == "```cpp" || (inside && line == "```")) {
                if (inside) { EXPECT_NE(here.find(squeezed(snippet)), std::string::npos) << page << ":\n" << snippet; }
                snippets += inside ? 1 : 0;
                inside = !inside;
                snippet.clear();
            } else if (inside) {
                snippet += line;
            }
        }
        EXPECT_FALSE(inside);
    }
    EXPECT_GE(snippets, 8);
}
