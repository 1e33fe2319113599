// gateway::client and gateway::server: each alone, and both over a line that breaks.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "trama/core/print.hpp"
#include "trama/gateway/client.hpp"
#include "trama/gateway/server.hpp"

namespace gateway = trama::gateway;
using gateway::client_news;
using gateway::server_news;
using octets = std::vector<std::uint8_t>;

namespace {

using server_of_3 = gateway::server<3>;

template <class M>
octets record(const M& m) {
    octets out(gateway::max_record);
    const auto size = gateway::format::encode_unchecked({}, m, out);
    EXPECT_TRUE(size);
    out.resize(*size);
    return out;
}
gateway::load load_for(std::uint32_t cart, std::string_view cargo = "box") {
    gateway::load m{};
    m.cart_id = cart;
    m.station_id = 12;
    m.level = 3;
    m.cargo_id = trama::text<10>(cargo);
    return m;
}
// One record through the server; its reply and what it said.
struct answered {
    gateway::server_event event;
    octets reply;
};
template <std::size_t N, class Judge = gateway::accept_all>
answered ask(gateway::server<N>& s, std::span<const std::uint8_t> in, Judge judge = {}) {
    octets out(gateway::max_record);
    const auto e = s.next(s.active(), in, 0, out, judge);
    EXPECT_TRUE(in.empty());
    out.resize(e.written);
    return {e, out};
}
template <class M>
M only(const octets& from) {
    gateway::decoder d;
    std::span<const std::uint8_t> in(from);
    const auto e = d.next(in);
    EXPECT_TRUE(e && in.empty());
    const auto m = trama::decode<M>(e.packet);
    EXPECT_TRUE(m) << "another message came";
    return m.value_or(M{});
}
std::string_view words(const gateway::nack& n) {
    static trama::text<80> kept;
    kept = n.error_message;
    return kept.view();
}
template <class M>
std::string path(trama::field_ref at) {
    std::array<char, 100> room{};
    trama::text_sink out(room);
    trama::print_path<M>(out, at);
    return std::string(out.view());
}
server_of_3 server_with_cart_1() {
    server_of_3 s;
    s.carts().add(1);
    s.connect();
    octets out(gateway::max_record);
    while (s.poll(out) != 0) {}
    return s;
}

}  // namespace

TEST(message_ids, wrap_to_0_behind_99999) {
    gateway::message_ids ids(99998);
    for (const std::uint32_t expected : {99998U, 99999U, 0U, 1U}) {
        EXPECT_EQ(ids.peek(), expected);
        ids.advance();
    }
}

TEST(gateway_server, answers_a_load_by_transit_ack_and_fills_a_slot) {
    auto s = server_with_cart_1();
    auto m = load_for(1);
    m.msg_id = 77;
    m.initial_inputs = "0110";
    const auto [event, reply] = ask(s, record(m));
    EXPECT_EQ(event.news, server_news::accepted);
    const auto ack = only<gateway::transit_ack>(reply);
    EXPECT_EQ(ack.src_type, gateway::order_type::load);
    EXPECT_EQ(ack.src_msg_id, 77U);
    EXPECT_EQ(ack.cart_id, 1U);
    EXPECT_EQ(ack.transit_id, event.transit_id);
    const auto* slot = s.carts().find(1)->slots.find(ack.transit_id);
    ASSERT_NE(slot, nullptr);
    EXPECT_EQ(slot->use, gateway::order_use::current);
    EXPECT_EQ(slot->station_id, 12U);
    EXPECT_EQ(slot->level, 3);
    EXPECT_EQ(slot->cargo_id.view(), "box");
    EXPECT_EQ(slot->inputs.view(), "0110");
}

TEST(gateway_server, reports_conditions_without_a_name_as_they_are) {
    auto s = server_with_cart_1();
    auto& cart = *s.carts().find(1);
    cart.state.cart_status = static_cast<gateway::cart_status>(0x1000) | gateway::cart_status::loaded;
    EXPECT_EQ(cart.report(s.circuit().mode).cart_status, static_cast<gateway::cart_status>(0x1000) | gateway::cart_status::loaded | gateway::cart_status::ready);
}

TEST(gateway_server, answers_each_kind_of_order_by_the_reply_that_the_document_gives_it) {
    auto s = server_with_cart_1();
    gateway::go_node node{};
    node.cart_id = 1;
    node.node = 9;
    EXPECT_EQ(only<gateway::transit_ack>(ask(s, record(node)).reply).src_type, gateway::order_type::go_node);
    EXPECT_EQ(s.carts().find(1)->slots.orders()[0].node, 9U);
    gateway::go_parking parking{};
    parking.cart_id = 1;
    EXPECT_EQ(only<gateway::transit_ack>(ask(s, record(parking)).reply).src_type, gateway::order_type::go_parking);
    s.carts().find(1)->slots.advance(gateway::transit_phase::transit_done);
    const auto transit = only<gateway::transit_ack>(ask(s, record(load_for(1))).reply);
    EXPECT_EQ(transit.src_type, gateway::order_type::load);

    const auto acked = [&](auto m) {
        m.msg_id = 5;
        const auto a = only<gateway::ack>(ask(s, record(m)).reply);
        return a.src_type == decltype(m)::key && a.src_msg_id == 5;
    };
    EXPECT_TRUE(acked(gateway::send_command{0, 1, transit.transit_id, "lift"}));
    EXPECT_TRUE(acked(gateway::send_inputs{0, 1, transit.transit_id, "1"}));
    EXPECT_TRUE(acked(gateway::send_cargo_id{0, 1, transit.transit_id, "box"}));
    const auto* slot = s.carts().find(1)->slots.find(transit.transit_id);
    EXPECT_EQ(slot->last_command.view(), "lift");
    EXPECT_EQ(slot->inputs.view(), "1");
    EXPECT_EQ(slot->cargo_id.view(), "box");
    s.carts().find(1)->state.cross_confirmation_needed = 1;
    s.carts().find(1)->state.end_node = 4;
    EXPECT_TRUE(acked(gateway::cross_granted{0, 1, 4}));
    EXPECT_EQ(s.carts().find(1)->state.cross_confirmation_needed, 0);
    EXPECT_TRUE(acked(gateway::cancel_transits{0, 1}));
    EXPECT_EQ(s.carts().find(1)->slots.find(gateway::order_use::current), nullptr);
    EXPECT_TRUE(acked(gateway::idle_processing{}));
}

TEST(gateway_server, says_why_it_refuses) {
    auto s = server_with_cart_1();
    const auto refused = [&](const auto& m) {
        const auto [event, reply] = ask(s, record(m));
        EXPECT_EQ(event.news, server_news::refused);
        const auto n = only<gateway::nack>(reply);
        EXPECT_EQ(n.src_type, m.key);
        EXPECT_EQ(n.src_msg_id, m.msg_id);
        return std::string(words(n));
    };
    EXPECT_EQ(refused(load_for(2)), gateway::reason::unknown_cart);
    auto high = load_for(1);
    high.level = 17;
    EXPECT_EQ(refused(high), gateway::reason::out_of_range);
    EXPECT_EQ(refused(gateway::send_command{3, 1, "T9", "lift"}), gateway::reason::unknown_transit);
    EXPECT_EQ(refused(gateway::cross_granted{3, 1, 4}), gateway::reason::not_waiting);
    s.carts().find(1)->state.cross_confirmation_needed = 1;
    s.carts().find(1)->state.end_node = 5;
    EXPECT_EQ(refused(gateway::cross_granted{3, 1, 4}), gateway::reason::not_waiting) << "it waits at another node";
    ask(s, record(load_for(1)));
    ask(s, record(load_for(1)));
    EXPECT_EQ(refused(load_for(1)), gateway::reason::no_place);
    s.carts().add(2)->state.cart_status = gateway::cart_status::maintenance;
    EXPECT_EQ(refused(load_for(2)), gateway::reason::not_ready);
    const auto veto = [](const auto&, const gateway::cart*) { return std::string_view{"not today"}; };
    EXPECT_EQ(words(only<gateway::nack>(ask(s, record(gateway::idle_processing{}), veto).reply)), "not today");
}

TEST(gateway_server, takes_commands_only_for_a_transit_with_a_station_that_is_not_over) {
    using gateway::order_type, gateway::transit_phase;
    auto s = server_with_cart_1();
    auto& slots = s.carts().find(1)->slots;
    const auto said = [&](const auto& m) {
        const auto [event, reply] = ask(s, record(m));
        return event.news == server_news::accepted ? std::string("yes") : std::string(words(only<gateway::nack>(reply)));
    };
    const auto all_three_said = [&](const trama::text<10>& transit) {
        const std::string first = said(gateway::send_command{1, 1, transit, "lift"});
        EXPECT_EQ(said(gateway::send_inputs{2, 1, transit, "1"}), first);
        EXPECT_EQ(said(gateway::send_cargo_id{3, 1, transit, "bag"}), first);
        return first;
    };
    const auto given = [&](const auto& m) { return ask(s, record(m)).event.transit_id; };
    const auto node = given(gateway::go_node{4, 1, 9});
    const auto parking = given(gateway::go_parking{5, 1, 9});
    EXPECT_EQ(all_three_said(node), gateway::reason::no_station);
    EXPECT_EQ(all_three_said(parking), gateway::reason::no_station);
    ask(s, record(gateway::cancel_transits{6, 1}));
    for (const auto type : {order_type::load, order_type::transit, order_type::unload}) {
        ask(s, record(gateway::cancel_transits{6, 1}));
        const auto running = type == order_type::load ? given(gateway::load{7, 1}) : type == order_type::transit ? given(gateway::transit{7, 1}) : given(gateway::unload{7, 1});
        const auto waiting = given(load_for(1));
        EXPECT_EQ(all_three_said(running), "yes");
        EXPECT_EQ(all_three_said(waiting), "yes");
        ASSERT_TRUE(slots.advance(transit_phase::transiting));
        EXPECT_EQ(all_three_said(running), "yes");
        ASSERT_TRUE(slots.advance(transit_phase::transit_done));
        EXPECT_EQ(all_three_said(running), gateway::reason::unknown_transit) << "previous";
        ASSERT_TRUE(slots.advance(transit_phase::transit_done));
        EXPECT_EQ(all_three_said(waiting), gateway::reason::unknown_transit) << "current, yet done";
    }
}

TEST(gateway_server, takes_no_new_transits_while_the_circuits_mode_forbids_them) {
    using gateway::cart_status, gateway::circuit_mode;
    auto s = server_with_cart_1();
    const auto& cart = *s.carts().find(1);
    octets out(gateway::max_record);
    const auto status = [&] {  // what the client is told; the circuit's state is left out
        cart_status told = cart_status::none;
        while (const std::size_t n = s.poll(out))
            if (n == gateway::max_record) told = only<gateway::cart_state>(out).cart_status | cart_status::warning;  // as a mark that it came
        return told;
    };
    const auto set = [&](circuit_mode mode) {
        gateway::circuit_state circuit{};
        circuit.mode = mode;
        circuit.target_mode = circuit_mode::automatic;
        s.set_circuit(circuit);
    };
    const auto load = ask(s, record(load_for(1))).event.transit_id;
    EXPECT_EQ(status(), cart_status::busy | cart_status::ready | cart_status::warning);
    for (const auto mode : {circuit_mode::semi_automatic, circuit_mode::manual}) {
        SCOPED_TRACE(trama::name_of(mode));
        set(mode);
        EXPECT_EQ(status(), cart_status::busy | cart_status::warning) << "carts are not ready any more, and the client is told";
        EXPECT_EQ(cart.report(s.circuit().mode).cart_status, cart_status::busy);
        server_of_3 later;
        later.set_circuit(s.circuit());
        EXPECT_EQ(later.carts().add(1)->report(mode).cart_status, cart_status::none) << "a cart that comes later";
        const auto [event, reply] = ask(s, record(load_for(1)));
        EXPECT_EQ(event.news, server_news::refused);
        EXPECT_EQ(words(only<gateway::nack>(reply)), gateway::reason::no_transits);
        EXPECT_EQ(ask(s, record(gateway::go_node{1, 1, 2})).event.news, server_news::refused);
        EXPECT_EQ(ask(s, record(gateway::send_inputs{1, 1, load, "1"})).event.news, server_news::accepted) << "what runs goes on";
        status();
        set(mode);
        EXPECT_EQ(status(), cart_status::none) << "the same mode once more is no change of a cart";
        set(circuit_mode::automatic);
        EXPECT_EQ(status(), cart_status::busy | cart_status::ready | cart_status::warning);
    }
    EXPECT_EQ(ask(s, record(load_for(1))).event.news, server_news::accepted);
    using enum circuit_mode;
    for (const auto mode : {no_power_freezing, no_power_frozen, init, automatic, shutdown_ready, shutting_down}) EXPECT_TRUE(gateway::takes_transits(mode)) << trama::name_of(mode);
}

TEST(gateway_server, refuses_in_words_that_no_record_can_carry_all_the_same) {
    auto s = server_with_cart_1();
    const auto told = [&](std::string_view why) {
        const auto [event, reply] = ask(s, record(load_for(1)), [&](const auto&, const gateway::cart*) { return why; });
        EXPECT_EQ(event.news, server_news::refused);
        EXPECT_EQ(event.reason, why);
        return std::string(words(only<gateway::nack>(reply)));
    };
    EXPECT_EQ(told("estaci\xc3\xb3n ocupada"), "estaci??n ocupada");
    EXPECT_EQ(told("a\x02" "b\x03" "c\x7f\n~"), "a?b?c??~");
    EXPECT_EQ(told(std::string_view("\0busy", 5)), "?busy");
    EXPECT_EQ(told(std::string(90, 'x') + "\n"), std::string(80, 'x'));
    EXPECT_EQ(s.carts().find(1)->slots.find(gateway::order_use::current), nullptr);
}

TEST(gateway_server, answers_an_order_with_a_broken_field_as_long_as_its_number_can_be_read) {
    auto s = server_with_cart_1();
    auto m = load_for(1);
    m.msg_id = 31;
    octets broken = record(m);
    broken[1 + 3 + 5 + 5] = 'x';  // station_id
    const auto [event, reply] = ask(s, broken);
    EXPECT_EQ(event.news, server_news::refused);
    const auto n = only<gateway::nack>(reply);
    EXPECT_EQ(n.src_msg_id, 31U);
    EXPECT_EQ(n.cart_id, 1U);
    EXPECT_EQ(words(n), gateway::reason::bad_number);
    broken[1 + 3] = 'x';  // msg_id
    const auto [mute, nothing] = ask(s, broken);
    EXPECT_EQ(mute.news, server_news::fault);
    EXPECT_EQ(mute.code, trama::errc::bad_number);
    EXPECT_TRUE(nothing.empty());
}

TEST(gateway_server, answers_nothing_that_is_no_order) {
    auto s = server_with_cart_1();
    EXPECT_EQ(ask(s, record(gateway::ack{})).event.news, server_news::foreign);
    const std::string other = "\x02" "777hello\x03";
    const auto [event, reply] = ask(s, octets(other.begin(), other.end()));
    EXPECT_EQ(event.news, server_news::foreign);
    EXPECT_TRUE(reply.empty());
    const std::string noise = "abc\x02";
    std::span<const std::uint8_t> in(reinterpret_cast<const std::uint8_t*>(noise.data()), noise.size());
    octets out(gateway::max_record);
    const auto fault = s.next(s.active(), in, 0, out);
    EXPECT_EQ(fault.news, server_news::fault);
    EXPECT_EQ(fault.skipped, 3U);
    EXPECT_EQ(s.quality().bytes_skipped, 3U);
}

TEST(gateway_server, a_new_connection_wins_and_the_old_ones_bytes_are_thrown_away) {
    auto s = server_with_cart_1();
    const auto old = s.active();
    const octets order = record(load_for(1));
    // Half an order on the old connection, the other half arrives when the new one holds.
    std::span<const std::uint8_t> half(order.data(), 20);
    octets out(gateway::max_record);
    EXPECT_EQ(s.next(old, half, 0, out).news, server_news::need_more);
    const auto fresh = s.connect();
    EXPECT_NE(fresh, old);
    std::span<const std::uint8_t> rest(order.data() + 20, order.size() - 20);
    const auto e = s.next(old, rest, 0, out);
    EXPECT_EQ(e.news, server_news::stale);
    EXPECT_EQ(e.skipped, order.size() - 20);
    EXPECT_TRUE(rest.empty());
    std::span<const std::uint8_t> whole(order);
    EXPECT_EQ(s.next(old, whole, 0, out).news, server_news::stale);
    EXPECT_EQ(s.carts().find(1)->slots.find(gateway::order_use::current), nullptr);
    EXPECT_EQ(ask(s, order).event.news, server_news::accepted);
    s.disconnect(old);
    EXPECT_EQ(s.active(), fresh) << "the end of the old connection ended the new one";
    s.disconnect(fresh);
    EXPECT_EQ(s.active(), 0U);
}

TEST(gateway_server, tells_a_new_client_every_state_and_then_only_changes) {
    server_of_3 s;
    s.carts().add(1);
    s.carts().add(2);
    octets out(gateway::max_record);
    EXPECT_EQ(s.poll(out), 0U) << "a state without a client";
    s.connect();
    std::vector<int> kinds;
    while (const std::size_t n = s.poll(out)) kinds.push_back(out[1] == '2' ? out[3] - '0' : -1);
    EXPECT_EQ(kinds, (std::vector<int>{0, 0, 1}));
    EXPECT_EQ(s.poll(out), 0U);
    ask(s, record(load_for(2)));
    octets small(gateway::max_record - 1);
    EXPECT_EQ(s.poll(small), 0U) << "a state that does not fit";
    ASSERT_EQ(s.poll(out), gateway::max_record);
    const auto state = only<gateway::cart_state>(out);
    EXPECT_EQ(state.cart_id, 2U);
    EXPECT_EQ(state.cart_phase, gateway::cart_phase::go_load);
    EXPECT_EQ(state.cart_status, gateway::cart_status::busy | gateway::cart_status::ready);
    EXPECT_EQ(s.poll(out), 0U);
}

TEST(gateway_server, tells_of_the_circuit_however_often_its_carts_change) {
    server_of_3 s;
    s.carts().add(1);
    s.carts().add(2);
    s.connect();
    octets out(gateway::max_record);
    std::map<std::size_t, int> sent;  // by size
    for (int i = 0; i != 30; ++i) {
        s.carts()[0].changed = s.carts()[1].changed = true;
        s.set_circuit({});
        ++sent[s.poll(out)];
    }
    EXPECT_EQ(sent[gateway::max_record], 20);
    EXPECT_EQ(sent[gateway::format::encoded_size(gateway::circuit_state{})], 10) << "one in three";

    server_of_3 empty;
    empty.connect();
    EXPECT_EQ(empty.poll(out), gateway::format::encoded_size(gateway::circuit_state{})) << "a circuit without carts";
    EXPECT_EQ(empty.poll(out), 0U);
}

TEST(gateway_server, sends_no_violation_and_tells_which_state_it_cannot_send) {
    server_of_3 s;
    s.carts().add(1);
    s.carts().add(2);
    octets out(gateway::max_record);
    const auto sent = [&] {  // carts by their number, the circuit as 0
        std::vector<std::uint32_t> all;
        while (const std::size_t n = s.poll(out)) {
            const octets one(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(n));
            all.push_back(n == gateway::max_record ? only<gateway::cart_state>(one).cart_id : 0);
        }
        return all;
    };
    s.carts()[0].state.rel_position = 250;
    EXPECT_FALSE(s.unsendable()) << "due to nobody";
    s.connect();
    ASSERT_TRUE(s.unsendable());
    EXPECT_EQ(sent(), (std::vector<std::uint32_t>{2, 0}));
    const gateway::unsendable_state why = s.unsendable();
    EXPECT_EQ(why.type, gateway::order_type::cart_state);
    EXPECT_EQ(why.cart_id, 1U);
    EXPECT_EQ(why.fault.code, trama::errc::out_of_range);
    EXPECT_EQ(path<gateway::cart_state>(why.fault.field), "rel_position");
    EXPECT_EQ(sent(), (std::vector<std::uint32_t>{})) << "still not";
    s.carts()[0].state.rel_position = 100;  // mended: it is due since before
    EXPECT_FALSE(s.unsendable());
    EXPECT_EQ(sent(), (std::vector<std::uint32_t>{1}));

    gateway::circuit_state circuit{};
    circuit.circuit_voltage = 12000;
    s.set_circuit(circuit);
    s.carts()[1].changed = true;
    EXPECT_EQ(sent(), (std::vector<std::uint32_t>{2}));
    EXPECT_EQ(s.unsendable().type, gateway::order_type::circuit_state);
    EXPECT_EQ(s.unsendable().cart_id, 0U);
    EXPECT_EQ(path<gateway::circuit_state>(s.unsendable().fault.field), "circuit_voltage");
    circuit.circuit_voltage = 482;
    circuit.mode = static_cast<gateway::circuit_mode>(9);
    s.set_circuit(circuit);
    EXPECT_TRUE(s.unsendable());
    circuit.mode = gateway::circuit_mode::automatic;
    s.set_circuit(circuit);
    EXPECT_EQ(sent(), (std::vector<std::uint32_t>{0}));

    s.carts()[1].state.cart_status = static_cast<gateway::cart_status>(10000);
    s.carts()[1].changed = true;
    EXPECT_EQ(s.unsendable().cart_id, 2U);
    s.disconnect(s.active());
    EXPECT_FALSE(s.unsendable());
}

TEST(gateway_server, numbers_states_itself_whatever_number_they_hold) {
    auto s = server_with_cart_1();
    s.carts().find(1)->state.msg_id = 100000;  // which no record can carry
    s.carts().find(1)->changed = true;
    auto circuit = s.circuit();
    circuit.msg_id = 100000;
    s.set_circuit(circuit);
    EXPECT_FALSE(s.unsendable());
    octets out(gateway::max_record);
    EXPECT_NE(s.poll(out), 0U);
    EXPECT_NE(s.poll(out), 0U);
    EXPECT_EQ(s.poll(out), 0U);
}

TEST(gateway_server, a_cart_is_busy_until_its_transit_is_done) {
    using gateway::cart_status, gateway::transit_phase;
    auto s = server_with_cart_1();
    auto& cart = *s.carts().find(1);
    EXPECT_EQ(cart.report(s.circuit().mode).cart_status, cart_status::ready);
    ask(s, record(load_for(1)));
    EXPECT_EQ(cart.report(s.circuit().mode).cart_status, cart_status::busy | cart_status::ready) << "on its way";
    ASSERT_TRUE(cart.slots.advance(transit_phase::transiting));
    EXPECT_EQ(cart.report(s.circuit().mode).cart_status, cart_status::busy | cart_status::ready) << "at work";
    ask(s, record(load_for(1)));
    EXPECT_EQ(cart.report(s.circuit().mode).cart_status, cart_status::busy) << "both slots taken";
    ASSERT_TRUE(cart.slots.advance(transit_phase::transit_done));
    ASSERT_TRUE(cart.slots.advance(transit_phase::transit_done));
    EXPECT_EQ(cart.report(s.circuit().mode).cart_status, cart_status::ready) << "done";
}

TEST(gateway_client, finds_cargo_that_a_cart_holds_or_has_just_delivered) {
    using gateway::order_use;
    for (const auto use : {order_use::unused, order_use::previous, order_use::current, order_use::next}) {
        gateway::cart_state state{};
        state.orders[1] = {use, gateway::order_type::load, 0, 12, 0, 0, "", "T1", "box", gateway::transit_phase::none, "", "", ""};
        EXPECT_EQ(gateway::find_cargo(state, "box"), use == order_use::unused ? nullptr : &state.orders[1]);
        EXPECT_EQ(gateway::find_cargo(state, "bag"), nullptr);
    }
}

TEST(gateway_server, numbers_its_messages_one_after_the_other) {
    server_of_3 s;
    s.carts().add(1);
    s.connect();
    octets out(gateway::max_record);
    const std::size_t size = s.poll(out);
    const std::uint32_t first = only<gateway::cart_state>({out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)}).msg_id;
    EXPECT_EQ(only<gateway::transit_ack>(ask(s, record(load_for(1))).reply).msg_id, first + 1);
    EXPECT_EQ(only<gateway::transit_ack>(ask(s, record(load_for(1))).reply).msg_id, first + 2);
}

TEST(gateway_server, consumes_nothing_when_a_reply_would_not_fit) {
    auto s = server_with_cart_1();
    const octets order = record(load_for(1));
    std::span<const std::uint8_t> in(order);
    octets small(server_of_3::max_reply - 1);
    EXPECT_EQ(s.next(s.active(), in, 0, small).news, server_news::no_room);
    EXPECT_EQ(in.size(), order.size());
    octets enough(server_of_3::max_reply);
    EXPECT_EQ(s.next(s.active(), in, 0, enough).news, server_news::accepted);
}

TEST(gateway_client, matches_replies_by_type_and_number) {
    gateway::client<4> c(1000, 99999);
    octets out(gateway::max_record);
    ASSERT_TRUE(c.send(load_for(1), 10, out));
    ASSERT_TRUE(c.send(gateway::cancel_transits{0, 1}, 11, out));
    EXPECT_EQ(c.next_id(), 1U);
    EXPECT_EQ(c.in_flight(), 2U);
    const auto told = [&](const auto& m, std::uint64_t now) {
        const octets b = record(m);
        std::span<const std::uint8_t> in(b);
        return c.next(in, now);
    };
    EXPECT_EQ(told(gateway::ack{0, 1, gateway::order_type::load, 99999}, 20).news, client_news::stray) << "ack for a load";
    EXPECT_EQ(told(gateway::transit_ack{0, 1, gateway::order_type::cancel_transits, 0, "T"}, 20).news, client_news::stray);
    EXPECT_EQ(told(gateway::transit_ack{0, 1, gateway::order_type::load, 0, "T"}, 20).news, client_news::stray) << "another's number";
    EXPECT_EQ(told(gateway::transit_ack{0, 1, gateway::order_type::none, 0, "T"}, 20).news, client_news::stray) << "matches an empty place";
    EXPECT_EQ(c.in_flight(), 2U);
    const auto yes = told(gateway::transit_ack{0, 1, gateway::order_type::load, 99999, "T1"}, 30);
    EXPECT_EQ(yes.news, client_news::accepted);
    EXPECT_EQ(yes.order, (gateway::order_in_flight{gateway::order_type::load, 99999, 1, 10}));
    const auto no = told(gateway::nack{0, 1, gateway::order_type::cancel_transits, 0, "no"}, 31);
    EXPECT_EQ(no.news, client_news::refused);
    EXPECT_EQ(c.in_flight(), 0U);
    EXPECT_EQ(c.quality().round_trip.most, 20U);
    EXPECT_EQ(told(gateway::cart_state{}, 32).news, client_news::state);
    EXPECT_EQ(told(gateway::load{}, 32).news, client_news::foreign);
    EXPECT_EQ(told(gateway::nack{0, 1, gateway::order_type::cancel_transits, 0, "no"}, 33).news, client_news::stray) << "twice";
}

TEST(gateway_client, takes_no_reply_that_names_another_cart) {
    gateway::client<4> c(1000);
    octets out(gateway::max_record);
    const auto told = [&](const auto& m) {
        const octets b = record(m);
        std::span<const std::uint8_t> in(b);
        return c.next(in, 1).news;
    };
    ASSERT_TRUE(c.send(load_for(1), 0, out));
    ASSERT_TRUE(c.send(gateway::cancel_transits{0, 1}, 0, out));
    ASSERT_TRUE(c.send(gateway::cross_granted{0, 0, 4}, 0, out));
    ASSERT_TRUE(c.send(gateway::idle_processing{}, 0, out));
    EXPECT_EQ(told(gateway::transit_ack{0, 2, gateway::order_type::load, 0, "T2"}), client_news::stray);
    EXPECT_EQ(told(gateway::nack{0, 2, gateway::order_type::load, 0, "no"}), client_news::stray);
    EXPECT_EQ(told(gateway::ack{0, 2, gateway::order_type::cancel_transits, 1}), client_news::stray);
    EXPECT_EQ(told(gateway::ack{0, 2, gateway::order_type::cross_granted, 2}), client_news::stray) << "cart 0 is a cart too";
    EXPECT_EQ(c.in_flight(), 4U);
    EXPECT_EQ(told(gateway::nack{0, 0, gateway::order_type::load, 0, "no"}), client_news::refused) << "it names no cart";
    EXPECT_EQ(told(gateway::ack{0, 1, gateway::order_type::cancel_transits, 1}), client_news::accepted);
    EXPECT_EQ(told(gateway::ack{0, 0, gateway::order_type::cross_granted, 2}), client_news::accepted);
    EXPECT_EQ(told(gateway::ack{0, 7, gateway::order_type::idle_processing, 3}), client_news::accepted) << "an order for no cart in particular";
}

TEST(gateway_client, gives_no_order_a_number_that_is_in_flight) {
    gateway::client<4> c(~std::uint64_t{0}, 99998);
    octets out(gateway::max_record);
    ASSERT_TRUE(c.send(load_for(1), 0, out));
    ASSERT_TRUE(c.send(load_for(2), 0, out));
    const auto done = [&](std::uint32_t id) {
        const octets b = record(gateway::ack{0, 0, gateway::order_type::idle_processing, id});
        std::span<const std::uint8_t> in(b);
        return c.next(in, 2).news == client_news::accepted;
    };
    for (std::uint32_t id = 0; id != 99998; ++id) {
        ASSERT_EQ(c.next_id(), id);
        ASSERT_TRUE(c.send(gateway::idle_processing{}, 1, out));
        ASSERT_TRUE(done(id));
    }
    EXPECT_EQ(c.next_id(), 0U) << "99998 and 99999 wait";
    auto high = load_for(3);
    high.level = 16;
    EXPECT_FALSE(c.send(high, 3, out));
    ASSERT_TRUE(c.send(load_for(3), 3, out));
    EXPECT_EQ(c.next_id(), 1U);
    const octets reply = record(gateway::transit_ack{0, 3, gateway::order_type::load, 0, "T3"});
    std::span<const std::uint8_t> in(reply);
    EXPECT_EQ(c.next(in, 4).order.cart_id, 3U);
    EXPECT_EQ(c.in_flight(), 2U);
}

TEST(gateway_client, hands_on_what_it_does_not_know_and_tells_what_is_broken) {
    gateway::client<4> c(1000);
    const auto told = [&](const octets& bytes) {
        std::span<const std::uint8_t> in(bytes);
        const auto e = c.next(in, 0);
        EXPECT_TRUE(in.empty());
        return e;
    };
    const auto framed = [](std::string_view payload) {
        octets all{gateway::stx};
        all.insert(all.end(), payload.begin(), payload.end());
        all.push_back(gateway::etx);
        return all;
    };
    const auto foreign = told(framed(" 77whatever"));
    EXPECT_EQ(foreign.news, client_news::foreign);
    EXPECT_EQ(foreign.packet.type(), 77);
    const auto broken = told(framed("101    1    x 15    1"));
    EXPECT_EQ(broken.news, client_news::fault);
    EXPECT_EQ(broken.code, trama::errc::bad_number);
    const auto noise = told(framed("101"));
    EXPECT_EQ(noise.news, client_news::fault);
    EXPECT_EQ(noise.code, trama::errc::bad_length);
    EXPECT_EQ(noise.skipped, 5U);
    EXPECT_EQ(c.quality().packets_received, 2U) << "the broken one has come, too";
    EXPECT_EQ(c.quality().bytes_received, 13U + 23U);
    EXPECT_EQ(c.quality().bytes_skipped, 5U);
}

TEST(gateway_cart, is_in_the_phase_that_its_current_order_is_in) {
    using gateway::cart_phase, gateway::order_type, gateway::transit_phase;
    struct row { order_type type; cart_phase going, there; };
    constexpr row rows[] = {
        {order_type::load, cart_phase::go_load, cart_phase::loading},
        {order_type::transit, cart_phase::go_transit, cart_phase::transiting},
        {order_type::unload, cart_phase::go_unload, cart_phase::unloading},
        {order_type::go_parking, cart_phase::go_parking, cart_phase::go_parking},
        {order_type::go_node, cart_phase::go_node, cart_phase::go_node},
        {order_type::none, cart_phase::none, cart_phase::none},
    };
    for (const row& r : rows) {
        gateway::transit_order o{};
        o.type = r.type;
        EXPECT_EQ(gateway::phase_of(o), cart_phase::none);
        o.phase = transit_phase::go_transit;
        EXPECT_EQ(gateway::phase_of(o), r.going);
        o.phase = transit_phase::transiting;
        EXPECT_EQ(gateway::phase_of(o), r.there);
        o.phase = transit_phase::transit_done;
        EXPECT_EQ(gateway::phase_of(o), cart_phase::transit_done);
    }
}

TEST(gateway_client, gives_up_orders_without_reply_once_each_and_oldest_first) {
    gateway::client<2> c(100);
    octets out(gateway::max_record);
    ASSERT_TRUE(c.send(load_for(1), 50, out));
    ASSERT_TRUE(c.send(load_for(2), 60, out));
    EXPECT_EQ(c.send(load_for(3), 60, out).code(), trama::errc::buffer_too_small) << "no place for a third";
    std::span<const std::uint8_t> none{};
    EXPECT_EQ(c.next(none, 150).news, client_news::need_more);
    const auto first = c.next(none, 161);
    EXPECT_EQ(first.news, client_news::timed_out);
    EXPECT_EQ(first.order.cart_id, 1U);
    EXPECT_EQ(c.next(none, 161).order.cart_id, 2U);
    EXPECT_EQ(c.next(none, 9999).news, client_news::need_more);
    EXPECT_EQ(c.quality().timeouts, 2U);
    EXPECT_EQ(c.quality().failures, 2U);
}

TEST(gateway_client, refuses_what_the_document_does_not_allow_without_using_a_number) {
    gateway::client<2> c(100, 7);
    octets out(gateway::max_record);
    auto m = load_for(1);
    m.level = 16;
    const auto r = c.send(m, 0, out);
    EXPECT_EQ(r.code(), trama::errc::out_of_range);
    EXPECT_EQ(c.send(load_for(1), 0, std::span(out).first(10)).code(), trama::errc::buffer_too_small);
    EXPECT_EQ(c.next_id(), 7U);
    EXPECT_EQ(c.in_flight(), 0U);
}

TEST(gateway_client, puts_orders_in_doubt_when_the_connection_is_lost) {
    gateway::client<4> c(1000);
    octets out(gateway::max_record);
    ASSERT_TRUE(c.send(load_for(1), 0, out));
    ASSERT_TRUE(c.send(load_for(2), 1, out));
    const octets reply = record(gateway::transit_ack{0, 1, gateway::order_type::load, 0, "T1"});
    std::span<const std::uint8_t> half(reply.data(), 9);
    EXPECT_EQ(c.next(half, 2).news, client_news::need_more);
    c.disconnected();
    const octets fresh = record(gateway::circuit_state{});
    std::span<const std::uint8_t> in(fresh);
    const auto cut = c.next(in, 3);
    EXPECT_EQ(cut.news, client_news::fault);
    EXPECT_EQ(cut.code, trama::errc::truncated);
    EXPECT_EQ(cut.skipped, 9U);
    EXPECT_EQ(c.next(in, 3).news, client_news::in_doubt);
    EXPECT_EQ(c.next(in, 3).order.cart_id, 2U);
    EXPECT_EQ(in.size(), fresh.size()) << "octets of the new connection were read before the old one was reported";
    EXPECT_EQ(c.next(in, 3).news, client_news::state);
    EXPECT_EQ(c.next_id(), 2U) << "numbers begin anew";
}

TEST(gateway_client, puts_no_order_in_doubt_that_the_next_connection_carries) {
    gateway::client<4> c(1000);
    octets out(gateway::max_record);
    c.disconnected();
    ASSERT_TRUE(c.send(gateway::idle_processing{}, 5, out));
    std::span<const std::uint8_t> none{};
    EXPECT_EQ(c.next(none, 6).news, client_news::need_more);
    const octets reply = record(gateway::ack{0, 0, gateway::order_type::idle_processing, 0});
    std::span<const std::uint8_t> in(reply);
    EXPECT_EQ(c.next(in, 7).news, client_news::accepted);

    // One order before the loss, a second one over the next connection, before the first is reported.
    ASSERT_TRUE(c.send(load_for(1), 10, out));
    c.disconnected();
    ASSERT_TRUE(c.send(load_for(2), 11, out));
    const auto lost = c.next(none, 2000);
    EXPECT_EQ(lost.news, client_news::in_doubt);
    EXPECT_EQ(lost.order.cart_id, 1U);
    const octets late = record(gateway::transit_ack{0, 2, gateway::order_type::load, 2, "T2"});
    in = late;
    EXPECT_EQ(c.next(in, 2000).news, client_news::accepted) << "its reply was there before it was late";
    EXPECT_EQ(c.quality().failures, 1U);

    // That one is lost as well when the next connection is.
    ASSERT_TRUE(c.send(load_for(3), 2001, out));
    c.disconnected();
    EXPECT_EQ(c.next(none, 2002).order.cart_id, 3U);
    EXPECT_EQ(c.next(none, 2002).news, client_news::need_more);
}

TEST(gateway_client, comes_to_an_end_when_each_order_in_doubt_is_sent_again) {
    gateway::client<4> c(1000);
    octets out(gateway::max_record);
    ASSERT_TRUE(c.send(gateway::cross_granted{0, 1, 7}, 0, out));
    ASSERT_TRUE(c.send(gateway::cross_granted{0, 2, 7}, 0, out));
    c.disconnected();
    int doubtful = 0;
    std::span<const std::uint8_t> none{};
    for (auto e = c.next(none, 1); e.news != client_news::need_more && doubtful != 10; e = c.next(none, 1)) {
        EXPECT_EQ(e.news, client_news::in_doubt);
        ++doubtful;
        ASSERT_TRUE(c.send(gateway::cross_granted{0, e.order.cart_id, 7}, 1, out));
    }
    EXPECT_EQ(doubtful, 2);
    EXPECT_EQ(c.in_flight(), 2U);
    EXPECT_EQ(c.next_id(), 4U);
    EXPECT_EQ(c.next(none, 1002).news, client_news::timed_out) << "sent again, and again without a reply";
}

// Law: with a connection that breaks at random places, over and over, every order is carried out exactly once, since
// the cart's state tells what became of those in doubt.
TEST(gateway_systems, every_order_is_carried_out_exactly_once_over_a_line_that_breaks) {
    for (unsigned seed = 1; seed != 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        gateway::server<1> s;
        s.carts().add(1);
        gateway::client<1> c(50);
        std::map<std::string, int> done;  // by cargo: how often the server took it
        octets up, down, out(gateway::max_record);
        auto session = s.connect();
        int goal = 25, next = 0, doubt = -1;
        bool seen_state = false, ready = false;
        std::uint64_t now = 0, settled = 0;
        for (; next < goal && now < 200000; ++now) {
            if (doubt < 0 && ready && c.in_flight() == 0) {
                const auto size = c.send(load_for(1, "c" + std::to_string(next)), now, out);
                ASSERT_TRUE(size);
                up.insert(up.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(*size));
                ready = false;
            }
            // Some octets each way, cut anywhere.
            const auto some = [&](octets& b) {
                const auto n = static_cast<std::ptrdiff_t>(std::min<std::size_t>(b.size(), random() % 60));
                octets piece(b.begin(), b.begin() + n);
                b.erase(b.begin(), b.begin() + n);
                return piece;
            };
            const octets to_server = some(up);
            for (std::span<const std::uint8_t> in(to_server);;) {
                const auto e = s.next(session, in, now, out);
                down.insert(down.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(e.written));
                if (e.news == server_news::need_more) break;
                if (e.news == server_news::accepted) ++done[std::string(s.carts()[0].slots.find(e.transit_id)->cargo_id.view())];
            }
            if (random() % 4 == 0) s.carts()[0].changed |= s.carts()[0].slots.advance(gateway::transit_phase::transit_done);
            while (down.size() < 500) {
                const std::size_t n = s.poll(out);
                if (n == 0) break;
                down.insert(down.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(n));
            }
            const bool broken = random() % 12 == 0;
            const octets to_client = some(down);
            if (broken) {
                up.clear();
                down.clear();
                session = s.connect();
                c.disconnected();
                ready = seen_state = false;
            }
            const octets nothing;
            for (std::span<const std::uint8_t> in(broken ? nothing : to_client);;) {
                const auto e = c.next(in, now);
                if (e.news == client_news::need_more) break;
                if (e.news == client_news::accepted) { ++next; ++settled; }
                if (e.news == client_news::in_doubt || e.news == client_news::timed_out) doubt = next;
                if (e.news != client_news::state) continue;
                const auto state = trama::decode<gateway::cart_state>(e.packet);
                if (!state) continue;
                seen_state = true;
                ready = gateway::any_of(state->cart_status, gateway::cart_status::ready);
                if (doubt < 0) continue;
                // A state of this connection was written after the old connection was closed for good.
                const bool taken = gateway::find_cargo(*state, trama::text<10>("c" + std::to_string(doubt))) != nullptr;
                if (taken) ++next;
                doubt = -1;
            }
        }
        ASSERT_EQ(next, goal) << "stuck at " << next << ", seen " << seen_state;
        EXPECT_GT(settled, 0U);
        EXPECT_EQ(done.size(), static_cast<std::size_t>(goal));
        for (const auto& [cargo, times] : done) EXPECT_EQ(times, 1) << cargo;
    }
}
