// Every state machine works at compile time: no I/O, clock, thread or heap can hide in it. And none of them may throw.
#include <gtest/gtest.h>

#include "trama/can/master.hpp"
#include "trama/can/sensor_node.hpp"
#include "trama/daisy/controller.hpp"
#include "trama/daisy/node.hpp"
#include "trama/gateway/client.hpp"
#include "trama/gateway/server.hpp"

namespace can = trama::can;
namespace daisy = trama::daisy;
namespace gateway = trama::gateway;
using octets = std::span<const std::uint8_t>;

namespace {

struct encoder {
    constexpr daisy::answer operator()(const daisy::dc_motor::get_encoder&, daisy::dc_motor::get_encoder_reply& r) noexcept {
        r.count = 1193046;
        return daisy::answer::done;
    }
};
constexpr std::int32_t ask_a_board() {
    daisy::controller<2, 4> controller;
    daisy::node<1, 8> node(daisy::board(1, 1), "motor");
    encoder device;
    std::array<std::uint8_t, daisy::node<1, 8>::max_output> there{}, back{};
    const std::size_t asked = *controller.request(daisy::board(1, 1), daisy::dc_motor::get_encoder{}, 0, there);
    octets in(there.data(), asked);
    const std::size_t answered = node.next(in, 1, back, device).written;
    in = octets(back.data(), answered);
    const auto e = controller.next(in, 2, there);
    return e.news == daisy::controller_news::reply ? trama::decode<daisy::dc_motor::get_encoder_reply>(e.packet)->count : 0;
}
static_assert(ask_a_board() == 1193046);

struct lamp {
    std::uint8_t state = 0;
    constexpr std::uint8_t read(std::uint8_t) noexcept { return 7; }
    constexpr bool set(std::uint8_t, std::uint8_t to) noexcept { state = to; return true; }
    constexpr bool get(std::uint8_t, std::uint8_t& to) const noexcept { to = state; return true; }
};
constexpr bool light_a_lamp() {
    can::master<1, 2> master(can::master_1);
    can::sensor_node<1> node(1, can::master_1, {0});
    lamp device;
    (void)master.request(can::set_actuator{1, 0, 0, 1});
    std::span<const can::frame> none{};
    (void)master.next(none, 0);
    const can::frame asked = *master.front();
    master.sent(0);
    std::span<const can::frame> in(&asked, 1);
    (void)node.next(in, 1, device);
    const can::frame answered = *node.front();
    node.sent();
    in = {&answered, 1};
    return master.next(in, 2).news == can::master_news::answered && device.state == 1;
}
static_assert(light_a_lamp());

constexpr bool order_a_load() {
    gateway::client<1> client(100);
    gateway::server<1> server;
    server.carts().add(1);
    const auto session = server.connect();
    std::array<std::uint8_t, gateway::max_record> there{}, back{};
    gateway::load m{};
    m.cart_id = 1;
    octets in(there.data(), *client.send(m, 0, there));
    in = octets(back.data(), server.next(session, in, 1, back).written);
    return client.next(in, 2).news == gateway::client_news::accepted && server.poll(back) == gateway::max_record;
}
static_assert(order_a_load());

template <class Machine, class... Arguments>
constexpr bool is_silent = noexcept(std::declval<Machine&>().next(std::declval<Arguments>()...));
static_assert(is_silent<daisy::controller<>, octets&, std::uint64_t, std::span<std::uint8_t>>);
static_assert(is_silent<daisy::node<>, octets&, std::uint64_t, std::span<std::uint8_t>, encoder&>);
static_assert(is_silent<can::master<>, std::span<const can::frame>&, std::uint64_t>);
static_assert(is_silent<can::sensor_node<>, std::span<const can::frame>&, std::uint64_t, lamp&>);
static_assert(is_silent<gateway::client<>, octets&, std::uint64_t>);
static_assert(is_silent<gateway::server<4>, gateway::server<4>::session, octets&, std::uint64_t, std::span<std::uint8_t>>);

// Memory is bounded by the template's parameters, and all of it is inside.
static_assert(std::is_trivially_copyable_v<daisy::controller<>> && std::is_trivially_copyable_v<daisy::node<>>);
static_assert(std::is_trivially_copyable_v<can::master<>> && std::is_trivially_copyable_v<can::sensor_node<>>);
static_assert(std::is_trivially_copyable_v<gateway::client<>> && std::is_trivially_copyable_v<gateway::server<4>>);

}  // namespace

TEST(systems, do_at_run_time_what_they_do_at_compile_time) {
    EXPECT_EQ(ask_a_board(), 1193046);
    EXPECT_TRUE(light_a_lamp());
    EXPECT_TRUE(order_a_load());
}

TEST(fresh_events, tell_of_nothing) {
    const auto plain = [](const auto& e) { return e.skipped == 0 && e.code == trama::errc::ok && e.packet.body().empty(); };
    const daisy::node_event board{};
    EXPECT_TRUE(plain(board) && board.written == 0 && board.news == daisy::node_news::need_more);
    const daisy::controller_event main{};
    EXPECT_TRUE(plain(main) && main.written == 0 && main.news == daisy::controller_news::need_more && main.command == 0 && main.attempt == 0 && !main.again);
    const can::master_event master{};
    EXPECT_TRUE(plain(master) && master.news == can::master_news::need_more && master.node == 0 && master.message_id == 0 && master.letter == 0 && master.attempt == 0 && !master.wrong);
    const can::sensor_node_event sensors{};
    EXPECT_TRUE(plain(sensors) && sensors.news == can::sensor_node_news::need_more);
    const gateway::server_event server{};
    EXPECT_TRUE(plain(server) && server.news == gateway::server_news::need_more && server.msg_id == 0 && server.cart_id == 0 && server.written == 0 && server.reason.empty());
    const gateway::client_event client{};
    EXPECT_TRUE(plain(client) && client.news == gateway::client_news::need_more && client.order == gateway::order_in_flight{});
    EXPECT_EQ(client.order.msg_id + client.order.cart_id + client.order.sent, 0U);
    const can::frame frame{};
    EXPECT_TRUE(frame.id == 0 && frame.time == 0 && frame.length == 0 && frame.classic());
    const auto silent = [](const auto& e) { return e.code == trama::errc::need_more && e.offset == 0 && e.length == 0 && e.bytes.empty() && e.packet.body().empty(); };
    EXPECT_TRUE(silent(daisy::event{}) && silent(can::event{}) && silent(gateway::event{}));
}
