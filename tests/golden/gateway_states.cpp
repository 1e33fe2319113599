// Golden vectors of the gateway's states. [gateway, "Mensajes de estado del Gateway"]
// One literal for each field, in the widths of the document's tables; numbers stand right in their columns.
#include "golden/gateway_row.hpp"

namespace trama::golden {
namespace {

using namespace gateway;

constexpr transit_order waiting{order_use::next, order_type::go_parking, 9, 0, 0, 0, "", "T000000043", "", transit_phase::none, "", "", ""};
constexpr transit_order running{order_use::current, order_type::transit, 0, 17, 3, 4, "FAST", "T000000042", "PALLET-9", transit_phase::go_transit, "0110", "", "LIFT"};
constexpr transit_order widest{order_use::previous, order_type::go_node, 99999, 99999, 99999, 15, "options890", "transit890", "cargo67890", transit_phase::transit_done, "inputs7890", "outputs890", "command890"};

constexpr std::tuple rows{
    // 3+5+5+4+1+5+3+5+5+5+1 = 42 characters, then 2 orders of 1+3+5+5+5+2+10+10+10+1+10+10+10 = 82: 206
    // status 704 = 512+128+64: loaded, ready, busy
    gateway_row("cart_state",
                record("200", "   31", "   12", " 704", "3", "  101", " 45", "  102", "  103", " 1250", "1",
                       "2", "  2", "    0", "   17", "    3", " 4", "FAST      ", "T000000042", "PALLET-9  ", "1", "0110      ", "          ", "LIFT      ",
                       "3", " 10", "    9", "    0", "    0", " 0", "          ", "T000000043", "          ", "0", "          ", "          ", "          "),
                cart_state{31, 12, cart_status::busy | cart_status::ready | cart_status::loaded, cart_phase::go_transit, 101, 45, 102, 103, 1250, 1, {running, waiting}},
                R"({"msg_id":31,"cart_id":12,"cart_status":["busy","ready","loaded"],"cart_phase":"go_transit","ini_node":101,"rel_position":45,"end_node":102,"next_node":103,"speed_mms":1250,"cross_confirmation_needed":1,"orders":[{"use":"current","type":"transit","node":0,"station_id":17,"station_type":3,"level":4,"options":"FAST","transit_id":"T000000042","cargo_id":"PALLET-9","phase":"go_transit","inputs":"0110","outputs":"","last_command":"LIFT"},{"use":"next","type":"go_parking","node":9,"station_id":0,"station_type":0,"level":0,"options":"","transit_id":"T000000043","cargo_id":"","phase":"none","inputs":"","outputs":"","last_command":""}]})"),
    // All zero and blank; a slot's type none is 0.
    gateway_row("cart_state",
                record("200", "    0", "    0", "   0", "0", "    0", "  0", "    0", "    0", "    0", "0",
                       "0", "  0", "    0", "    0", "    0", " 0", "          ", "          ", "          ", "0", "          ", "          ", "          ",
                       "0", "  0", "    0", "    0", "    0", " 0", "          ", "          ", "          ", "0", "          ", "          ", "          "),
                cart_state{},
                R"({"msg_id":0,"cart_id":0,"cart_status":[],"cart_phase":"none","ini_node":0,"rel_position":0,"end_node":0,"next_node":0,"speed_mms":0,"cross_confirmation_needed":0,"orders":[{"use":"unused","type":"none","node":0,"station_id":0,"station_type":0,"level":0,"options":"","transit_id":"","cargo_id":"","phase":"none","inputs":"","outputs":"","last_command":""},{"use":"unused","type":"none","node":0,"station_id":0,"station_type":0,"level":0,"options":"","transit_id":"","cargo_id":"","phase":"none","inputs":"","outputs":"","last_command":""}]})"),
    // Every column filled. status 4095 = 0xFFF: all twelve bits; speed -9999 takes five columns [D16]
    gateway_row("cart_state",
                record("200", "99999", "99998", "4095", "9", "99997", "100", "99996", "99995", "-9999", "0",
                       "1", " 15", "99999", "99999", "99999", "15", "options890", "transit890", "cargo67890", "3", "inputs7890", "outputs890", "command890",
                       "1", " 15", "99999", "99999", "99999", "15", "options890", "transit890", "cargo67890", "3", "inputs7890", "outputs890", "command890"),
                cart_state{99999, 99998, static_cast<cart_status>(0xFFF), cart_phase::go_node, 99997, 100, 99996, 99995, -9999, 0, {widest, widest}},
                R"({"msg_id":99999,"cart_id":99998,"cart_status":["cart_error","hook_error","warning","paused","manual_mode","maintenance","busy","ready","parking","loaded","house_keeping","shutdown_ready"],"cart_phase":"go_node","ini_node":99997,"rel_position":100,"end_node":99996,"next_node":99995,"speed_mms":-9999,"cross_confirmation_needed":0,"orders":[{"use":"previous","type":"go_node","node":99999,"station_id":99999,"station_type":99999,"level":15,"options":"options890","transit_id":"transit890","cargo_id":"cargo67890","phase":"transit_done","inputs":"inputs7890","outputs":"outputs890","last_command":"command890"},{"use":"previous","type":"go_node","node":99999,"station_id":99999,"station_type":99999,"level":15,"options":"options890","transit_id":"transit890","cargo_id":"cargo67890","phase":"transit_done","inputs":"inputs7890","outputs":"outputs890","last_command":"command890"}]})"),
    // 3+5+5+5+5+7+1+1 = 32; 48.2 V is held as 482; check 2099232 = 0x200820 = 2097152+2048+32
    gateway_row("circuit_state", record("201", "    8", " 48.2", " 12.5", "    7", "2099232", "5", "4"),
                circuit_state{8, 482, 125, 7, circuit_check::emergency_armed | circuit_check::door_open | circuit_check::all_carts_shutdown_ready, circuit_mode::automatic, circuit_mode::semi_automatic},
                R"({"msg_id":8,"circuit_voltage":48.2,"circuit_current":12.5,"working_carts":7,"check":["emergency_armed","door_open","all_carts_shutdown_ready"],"target_mode":"automatic","mode":"semi_automatic"})"),
    // 48.0 and 0.5 keep their decimal; check 4194303 = 0x3FFFFF: all 22 bits
    gateway_row("circuit_state", record("201", "    9", " 48.0", "  0.5", "    0", "4194303", "7", "0"),
                circuit_state{9, 480, 5, 0, static_cast<circuit_check>(0x3FFFFF), circuit_mode::shutting_down, circuit_mode::no_power_freezing},
                R"({"msg_id":9,"circuit_voltage":48.0,"circuit_current":0.5,"working_carts":0,"check":["cart_lost","cart_wrong_platform_version","cart_wrong_program_version","cart_wrong_firmware_version","cart_wrong_map","emergency_armed","door_opening","all_carts_no_power_frozen","cart_emergency","cart_unlocated","cart_traffic_check_failed","door_open","transport_interrupted","overvoltage","undervoltage","overcurrent","cart_wrong_powerboard_version","power_supplies_fail","battery_fault","shutting_down","circuit_breaker_48v","all_carts_shutdown_ready"],"target_mode":"shutting_down","mode":"no_power_freezing"})"),
    gateway_row("circuit_state", record("201", "    0", "999.9", "  0.0", "    1", "      0", "2", "3"),
                circuit_state{0, 9999, 0, 1, circuit_check::ok, circuit_mode::init, circuit_mode::manual},
                R"({"msg_id":0,"circuit_voltage":999.9,"circuit_current":0.0,"working_carts":1,"check":[],"target_mode":"init","mode":"manual"})"),
};
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

constexpr std::tuple limits{
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
