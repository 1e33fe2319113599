// What the golden vectors of the client's orders prove, and the limits of their fields. [gateway, "Órdenes hacia el gateway"]
#include "golden/gateway_limits.hpp"
#include "golden/vectors/gateway_orders.hpp"

namespace trama::golden {
namespace {

using namespace gateway;
using namespace golden::gateway_orders;

using client_messages = message_list<load, transit, unload, go_parking, go_node, cancel_transits, send_command, send_inputs, send_cargo_id, cross_granted, idle_processing>;
static_assert(covers<client_messages>(rows));
static_assert(proven<rows>);

template <class M>
constexpr M with_level(std::uint8_t level) { return {1, 2, 3, 4, level, "", "", ""}; }
constexpr broken level_16{"level", 16, "0..15"}, level_99{"level", 99, "0..15"};

constexpr table limits{
    allowed(with_level<load>(0)), allowed(with_level<load>(15)), refused(with_level<load>(16), level_16), refused(with_level<load>(99), level_99),
    allowed(with_level<transit>(0)), allowed(with_level<transit>(15)), refused(with_level<transit>(16), level_16), refused(with_level<transit>(99), level_99),
    allowed(with_level<unload>(0)), allowed(with_level<unload>(15)), refused(with_level<unload>(16), level_16), refused(with_level<unload>(99), level_99),
    allowed(go_parking{99999, 99999, 99999}), allowed(go_parking{}), allowed(go_node{99999, 99999, 99999}), allowed(go_node{}),
    allowed(cancel_transits{99999, 99999}), allowed(cancel_transits{}), allowed(cross_granted{99999, 99999, 99999}), allowed(cross_granted{}),
    allowed(idle_processing{99999}), allowed(idle_processing{0}), allowed(send_command{99999, 99999, "          ", "~~~~~~~~~~"}),
};
static_assert(limits_proven<limits>);

/// What the columns cannot hold, field by field.
constexpr bool five_columns_hold_99999() {
    bool all = no_room(with_level<load>(100), {4}) && no_room(with_level<transit>(255), {4}) && no_room(with_level<unload>(100), {4});
    all = all && no_room(load{100000, 0, 0, 0, 0, "", "", ""}, {0}) && no_room(load{0, 100000, 0, 0, 0, "", "", ""}, {1});
    all = all && no_room(load{0, 0, 100000, 0, 0, "", "", ""}, {2}) && no_room(load{0, 0, 0, 4294967295, 0, "", "", ""}, {3});
    all = all && no_room(go_parking{0, 0, 100000}, {2}) && no_room(go_node{0, 0, 100000}, {2}) && no_room(cross_granted{0, 0, 100000}, {2});
    return all && no_room(cancel_transits{0, 100000}, {1}) && no_room(idle_processing{100000}, {0});
}
/// Text longer than its field, and characters outside 0x20..0x7E, are refused by both encoders [D17].
constexpr bool texts_are_printable_and_fit() {
    bool all = no_room(send_command{0, 0, "12345678901", ""}, {2}) && no_room(send_command{0, 0, "", "12345678901"}, {3});
    all = all && no_room(send_inputs{0, 0, "", "\x1F"}, {3}) && no_room(send_inputs{0, 0, "a\x7F", ""}, {2});
    all = all && no_room(send_cargo_id{0, 0, "", "\x02"}, {3}) && no_room(send_cargo_id{0, 0, "", "         \x03"}, {3});
    return all && no_room(load{0, 0, 0, 0, 0, "\xE9", "", ""}, {5}) && no_room(load{0, 0, 0, 0, 0, "", "12345678901", ""}, {6});
}
static_assert(five_columns_hold_99999());
static_assert(texts_are_printable_and_fit());

TEST(gateway_orders, rows_hold) { check_rows(rows); }
TEST(gateway_orders, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(gateway_orders, one_damaged_byte_never_passes) { check_damage(rows, every_byte, same_number); }
TEST(gateway_orders, limits) { check_limits(limits); }
TEST(gateway_orders, what_has_no_room_is_never_written) {
    EXPECT_TRUE(five_columns_hold_99999());
    EXPECT_TRUE(texts_are_printable_and_fit());
}

}  // namespace
}  // namespace trama::golden
