// What the golden vectors of the gateway's replies prove, and the limits of their fields. [gateway, "Respuestas del gateway"]
#include "golden/gateway_limits.hpp"
#include "golden/vectors/gateway_replies.hpp"

namespace trama::golden {
namespace {

using namespace gateway;
using namespace golden::gateway_replies;

static_assert(covers<message_list<transit_ack, ack, nack>>(rows));
static_assert(proven<rows>);

constexpr std::string_view clients = "load|transit|unload|go_parking|go_node|cancel_transits|send_command|send_inputs|send_cargo_id|cross_granted|idle_processing";
constexpr broken none{"src_type", 0, clients}, unnamed_4{"src_type", 4, clients}, of_gateway{"src_type", 100, clients}, last{"src_type", 999, clients};
constexpr ack of(int type) { return {1, 2, static_cast<order_type>(type), 3}; }

constexpr table limits{
    allowed(of(1)), allowed(of(2)), allowed(of(3)), allowed(of(10)), allowed(of(15)), allowed(of(20)), allowed(of(21)), allowed(of(22)), allowed(of(23)), allowed(of(30)), allowed(of(50)),
    refused(of(0), none), refused(of(4), unnamed_4), refused(of(100), of_gateway), refused(of(999), last),
    refused(of(51), broken{"src_type", 51, clients}), refused(of(63), broken{"src_type", 63, clients}), refused(of(64), broken{"src_type", 64, clients}),
    refused(of(65), broken{"src_type", 65, clients}), refused(of(101), broken{"src_type", 101, clients}), refused(of(102), broken{"src_type", 102, clients}),
    refused(of(200), broken{"src_type", 200, clients}), refused(of(201), broken{"src_type", 201, clients}),
    refused(transit_ack{1, 2, order_type::none, 3, ""}, none), refused(transit_ack{1, 2, order_type::transit_ack, 3, ""}, of_gateway),
    refused(transit_ack{1, 2, static_cast<order_type>(999), 3, ""}, last), allowed(transit_ack{1, 2, order_type::idle_processing, 3, ""}),
    refused(nack{1, 2, order_type::none, 3, ""}, none), refused(nack{1, 2, static_cast<order_type>(4), 3, ""}, unnamed_4), allowed(nack{1, 2, order_type::load, 3, ""}),
};
static_assert(limits_proven<limits>);

constexpr bool columns_hold_so_much() {
    bool all = no_room(of(1000), {2}) && no_room(of(65535), {2}) && no_room(transit_ack{0, 0, order_type::load, 100000, ""}, {3});
    all = all && no_room(ack{100000, 0, order_type::load, 0}, {0}) && no_room(ack{0, 100000, order_type::load, 0}, {1}) && no_room(ack{0, 0, order_type::load, 100000}, {3});
    constexpr std::string_view of_81 = "0123456789abcdefghij0123456789abcdefghij0123456789abcdefghij0123456789abcdefghij!";
    static_assert(of_81.size() == 81);
    return all && no_room(nack{0, 0, order_type::load, 0, of_81}, {4}) && no_room(transit_ack{0, 0, order_type::load, 0, "12345678901"}, {4});
}
static_assert(columns_hold_so_much());

TEST(gateway_replies, rows_hold) { check_rows(rows); }
TEST(gateway_replies, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(gateway_replies, one_damaged_byte_never_passes) { check_damage(rows, every_byte, same_number); }
TEST(gateway_replies, limits) { check_limits(limits); }
TEST(gateway_replies, what_has_no_room_is_never_written) { EXPECT_TRUE(columns_hold_so_much()); }

}  // namespace
}  // namespace trama::golden
