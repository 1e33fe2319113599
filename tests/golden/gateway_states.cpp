// What the golden vectors of the gateway's states prove, and the limits of their fields. [gateway, "Mensajes de estado del Gateway"]
#include "golden/gateway_limits.hpp"
#include "golden/vectors/gateway_states.hpp"

namespace trama::golden {
namespace {

using namespace gateway;
using namespace golden::gateway_states;

static_assert(covers<message_list<cart_state, circuit_state>>(rows));
static_assert(messages::count == 11 + 3 + 2);
static_assert(proven<rows>);

constexpr cart_state cart(auto&& change) {
    cart_state s{};
    change(s);
    return s;
}
constexpr circuit_state circuit(auto&& change) {
    circuit_state s{};
    change(s);
    return s;
}
constexpr std::string_view uses = "unused|previous|current|next", phases = "none|go_transit|transiting|transit_done", slot_types = "none|load|transit|unload|go_parking|go_node";
constexpr std::string_view modes = "no_power_freezing|no_power_frozen|init|manual|semi_automatic|automatic|shutdown_ready|shutting_down";
constexpr cart_state with_type(int type) { return cart([=](auto& s) { s.orders[1].type = static_cast<order_type>(type); }); }

constexpr table limits{
    allowed(cart([](auto& s) { s.rel_position = 100; })), refused(cart([](auto& s) { s.rel_position = 101; }), broken{"rel_position", 101, "0..100"}),
    refused(cart([](auto& s) { s.rel_position = 999; }), broken{"rel_position", 999, "0..100"}),
    allowed(cart([](auto& s) { s.cross_confirmation_needed = 1; })), refused(cart([](auto& s) { s.cross_confirmation_needed = 2; }), broken{"cross_confirmation_needed", 2, "0..1"}),
    refused(cart([](auto& s) { s.cross_confirmation_needed = 9; }), broken{"cross_confirmation_needed", 9, "0..1"}),
    allowed(cart([](auto& s) { s.speed_mms = -9999; })), allowed(cart([](auto& s) { s.speed_mms = 99999; })), allowed(cart([](auto& s) { s.speed_mms = -1; })),
    allowed(cart([](auto& s) { s.cart_status = static_cast<cart_status>(9999); })), allowed(cart([](auto& s) { s.cart_phase = cart_phase::go_node; })),
    allowed(cart([](auto& s) { s.orders[0].level = 15; })), refused(cart([](auto& s) { s.orders[0].level = 17; }), broken{"orders[0].level", 17, "0..15"}),
    refused(cart([](auto& s) { s.orders[1].level = 16; }), broken{"orders[1].level", 16, "0..15"}), refused(cart([](auto& s) { s.orders[1].level = 99; }), broken{"orders[1].level", 99, "0..15"}),
    refused(cart([](auto& s) { s.orders[0].use = static_cast<order_use>(4); }), broken{"orders[0].use", 4, uses}), refused(cart([](auto& s) { s.orders[1].use = static_cast<order_use>(9); }), broken{"orders[1].use", 9, uses}),
    refused(cart([](auto& s) { s.orders[0].phase = static_cast<transit_phase>(4); }), broken{"orders[0].phase", 4, phases}), refused(cart([](auto& s) { s.orders[1].phase = static_cast<transit_phase>(9); }), broken{"orders[1].phase", 9, phases}),
    allowed(with_type(0)), allowed(with_type(1)), allowed(with_type(2)), allowed(with_type(3)), allowed(with_type(10)), allowed(with_type(15)),
    refused(with_type(4), broken{"orders[1].type", 4, slot_types}), refused(with_type(20), broken{"orders[1].type", 20, slot_types}), refused(with_type(50), broken{"orders[1].type", 50, slot_types}),
    refused(with_type(64), broken{"orders[1].type", 64, slot_types}), refused(with_type(100), broken{"orders[1].type", 100, slot_types}), refused(with_type(999), broken{"orders[1].type", 999, slot_types}),
    refused(cart([](auto& s) { s.rel_position = 101; s.cross_confirmation_needed = 2; s.orders[0].level = 16; s.orders[1].use = static_cast<order_use>(5); }),
            broken{"rel_position", 101, "0..100"}, broken{"cross_confirmation_needed", 2, "0..1"}, broken{"orders[0].level", 16, "0..15"}, broken{"orders[1].use", 5, uses}),
    allowed(circuit([](auto& s) { s.circuit_voltage = 9999; s.circuit_current = 9999; s.working_carts = 99999; })), allowed(circuit([](auto& s) { s.check = static_cast<circuit_check>(9999999); })),
    allowed(circuit([](auto& s) { s.target_mode = circuit_mode::shutting_down; s.mode = circuit_mode::shutting_down; })),
    refused(circuit([](auto& s) { s.target_mode = static_cast<circuit_mode>(8); }), broken{"target_mode", 8, modes}), refused(circuit([](auto& s) { s.mode = static_cast<circuit_mode>(9); }), broken{"mode", 9, modes}),
};
static_assert(limits_proven<limits>);

constexpr bool columns_hold_so_much() {
    bool all = no_room(cart([](auto& s) { s.cart_status = static_cast<cart_status>(10000); }), {2}) && no_room(cart([](auto& s) { s.cart_phase = static_cast<cart_phase>(10); }), {3});
    all = all && no_room(cart([](auto& s) { s.rel_position = 1000; }), {5}) && no_room(cart([](auto& s) { s.speed_mms = -10000; }), {8}) && no_room(cart([](auto& s) { s.speed_mms = 100000; }), {8});
    all = all && no_room(cart([](auto& s) { s.cross_confirmation_needed = 10; }), {9}) && no_room(cart([](auto& s) { s.orders[1].use = static_cast<order_use>(10); }), {10, 1, 0});
    all = all && no_room(with_type(1000), {10, 1, 1}) && no_room(cart([](auto& s) { s.orders[0].node = 100000; }), {10, 0, 2}) && no_room(cart([](auto& s) { s.orders[0].level = 100; }), {10, 0, 5});
    all = all && no_room(cart([](auto& s) { s.orders[1].outputs = "\t"; }), {10, 1, 11}) && no_room(circuit([](auto& s) { s.circuit_voltage = 10000; }), {1});
    return all && no_room(circuit([](auto& s) { s.circuit_current = 65535; }), {2}) && no_room(circuit([](auto& s) { s.check = static_cast<circuit_check>(10000000); }), {4}) &&
           no_room(circuit([](auto& s) { s.mode = static_cast<circuit_mode>(10); }), {6});
}
static_assert(columns_hold_so_much());

TEST(gateway_states, rows_hold) { check_rows(rows); }
TEST(gateway_states, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(gateway_states, one_damaged_byte_never_passes) { check_damage(rows, every_byte, same_number); }
TEST(gateway_states, limits) { check_limits(limits); }
TEST(gateway_states, what_has_no_room_is_never_written) { EXPECT_TRUE(columns_hold_so_much()); }

}  // namespace
}  // namespace trama::golden
