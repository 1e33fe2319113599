#pragma once
// Golden vectors of the gateway's states. [gateway, "Mensajes de estado del Gateway"]
// One literal for each field, in the widths of the document's tables; numbers stand right in their columns.
#include "golden/vectors/gateway_row.hpp"

namespace trama::golden::gateway_states {

using namespace gateway;

inline constexpr transit_order waiting{order_use::next, order_type::go_parking, 9, 0, 0, 0, "", "T000000043", "", transit_phase::none, "", "", ""};
inline constexpr transit_order running{order_use::current, order_type::transit, 0, 17, 3, 4, "FAST", "T000000042", "PALLET-9", transit_phase::go_transit, "0110", "", "LIFT"};
inline constexpr transit_order widest{order_use::previous, order_type::go_node, 99999, 99999, 99999, 15, "options890", "transit890", "cargo67890", transit_phase::transit_done, "inputs7890", "outputs890", "command890"};

inline constexpr table rows{
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

}  // namespace trama::golden::gateway_states
