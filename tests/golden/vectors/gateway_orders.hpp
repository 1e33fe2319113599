#pragma once
// Golden vectors of the client's orders. [gateway, "Órdenes hacia el gateway"]
// One literal for each field, in the widths of the document's tables; numbers stand right in their columns.
#include "golden/vectors/gateway_row.hpp"

namespace trama::golden::gateway_orders {

using namespace gateway;

inline constexpr table rows{
    // 3+5+5+5+5+2+10+10+10 = 55 characters
    gateway_row("load", record("  1", "    1", "   12", "  345", "    2", " 7", "FAST      ", "0110      ", "PALLET-9  "),
                load{1, 12, 345, 2, 7, "FAST", "0110", "PALLET-9"},
                R"({"msg_id":1,"cart_id":12,"station_id":345,"station_type":2,"level":7,"options":"FAST","initial_inputs":"0110","cargo_id":"PALLET-9"})"),
    gateway_row("load", record("  1", "99999", "99999", "99999", "99999", "15", "0123456789", "ABCDEFGHIJ", "~!\"#$%&'()"),
                load{99999, 99999, 99999, 99999, 15, "0123456789", "ABCDEFGHIJ", "~!\"#$%&'()"},
                R"json({"msg_id":99999,"cart_id":99999,"station_id":99999,"station_type":99999,"level":15,"options":"0123456789","initial_inputs":"ABCDEFGHIJ","cargo_id":"~!\"#$%&'()"})json"),
    gateway_row("load", record("  1", "    0", "    0", "    0", "    0", " 0", "          ", "          ", "          "), load{},
                R"({"msg_id":0,"cart_id":0,"station_id":0,"station_type":0,"level":0,"options":"","initial_inputs":"","cargo_id":""})"),
    gateway_row("transit", record("  2", "    2", "    3", "    4", "    5", " 6", " a b      ", "c         ", "d\\        "),
                transit{2, 3, 4, 5, 6, " a b", "c", "d\\"},
                R"({"msg_id":2,"cart_id":3,"station_id":4,"station_type":5,"level":6,"options":" a b","initial_inputs":"c","cargo_id":"d\\"})"),
    gateway_row("unload", record("  3", "12345", "23456", "34567", "45678", "12", "X         ", "Y         ", "Z         "),
                unload{12345, 23456, 34567, 45678, 12, "X", "Y", "Z"},
                R"({"msg_id":12345,"cart_id":23456,"station_id":34567,"station_type":45678,"level":12,"options":"X","initial_inputs":"Y","cargo_id":"Z"})"),
    // 3+5+5+5 = 18
    gateway_row("go_parking", record(" 10", "    4", "   12", "    0"), go_parking{4, 12, 0}, R"({"msg_id":4,"cart_id":12,"parking_node":0})"),
    gateway_row("go_node", record(" 15", "    5", "   12", " 1024"), go_node{5, 12, 1024}, R"({"msg_id":5,"cart_id":12,"node":1024})"),
    // 3+5+5 = 13
    gateway_row("cancel_transits", record(" 20", "    6", "   12"), cancel_transits{6, 12}, R"({"msg_id":6,"cart_id":12})"),
    // 3+5+5+10+10 = 33
    gateway_row("send_command", record(" 21", "    7", "   12", "T000000042", "LIFT      "), send_command{7, 12, "T000000042", "LIFT"},
                R"({"msg_id":7,"cart_id":12,"transit_id":"T000000042","command":"LIFT"})"),
    gateway_row("send_inputs", record(" 22", "    8", "   12", "T000000042", "1001      "), send_inputs{8, 12, "T000000042", "1001"},
                R"({"msg_id":8,"cart_id":12,"transit_id":"T000000042","inputs":"1001"})"),
    // The document prints type send_command in this table; the list of types says 23 [D13].
    gateway_row("send_cargo_id", record(" 23", "    9", "   12", "T000000042", "PALLET-10 "), send_cargo_id{9, 12, "T000000042", "PALLET-10"},
                R"({"msg_id":9,"cart_id":12,"transit_id":"T000000042","cargo_id":"PALLET-10"})"),
    gateway_row("cross_granted", record(" 30", "   10", "   12", "  102"), cross_granted{10, 12, 102}, R"({"msg_id":10,"cart_id":12,"node":102})"),
    // 3+5 = 8
    gateway_row("idle_processing", record(" 50", "   11"), idle_processing{11}, R"({"msg_id":11})"),
};

}  // namespace trama::golden::gateway_orders
