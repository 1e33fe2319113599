// Golden vectors of the gateway's replies. [gateway, "Respuestas del gateway"]
// One literal for each field, in the widths of the document's tables; numbers stand right in their columns.
#include "golden/gateway_row.hpp"

namespace trama::golden {
namespace {

using namespace gateway;

constexpr std::tuple rows{
    // 3+5+5+3+5+10 = 31 characters
    gateway_row("transit_ack", record("100", "    1", "   12", "  1", "    1", "T000000042"), transit_ack{1, 12, order_type::load, 1, "T000000042"},
                R"({"msg_id":1,"cart_id":12,"src_type":"load","src_msg_id":1,"transit_id":"T000000042"})"),
    gateway_row("transit_ack", record("100", "99999", "99999", " 15", "99999", "          "), transit_ack{99999, 99999, order_type::go_node, 99999, ""},
                R"({"msg_id":99999,"cart_id":99999,"src_type":"go_node","src_msg_id":99999,"transit_id":""})"),
    // 3+5+5+3+5 = 21
    gateway_row("ack", record("101", "    2", "   12", " 20", "    6"), ack{2, 12, order_type::cancel_transits, 6},
                R"({"msg_id":2,"cart_id":12,"src_type":"cancel_transits","src_msg_id":6})"),
    gateway_row("ack", record("101", "    3", "    0", " 50", "   11"), ack{3, 0, order_type::idle_processing, 11},
                R"({"msg_id":3,"cart_id":0,"src_type":"idle_processing","src_msg_id":11})"),
    // 3+5+5+3+5+80 = 101: the text has 80 characters [D14], here 20 and six times ten spaces
    gateway_row("nack", record("102", "    4", "   13", " 10", "    7", "cart 13 is not ready", "          ", "          ", "          ", "          ", "          ", "          "),
                nack{4, 13, order_type::go_parking, 7, "cart 13 is not ready"},
                R"({"msg_id":4,"cart_id":13,"src_type":"go_parking","src_msg_id":7,"error_message":"cart 13 is not ready"})"),
    gateway_row("nack", record("102", "    5", "   14", " 21", "    8", "0123456789abcdefghij", "0123456789abcdefghij", "0123456789abcdefghij", "0123456789abcdefghiJ"),
                nack{5, 14, order_type::send_command, 8, "0123456789abcdefghij0123456789abcdefghij0123456789abcdefghij0123456789abcdefghiJ"},
                R"({"msg_id":5,"cart_id":14,"src_type":"send_command","src_msg_id":8,"error_message":"0123456789abcdefghij0123456789abcdefghij0123456789abcdefghij0123456789abcdefghiJ"})"),
};
static_assert(covers<message_list<transit_ack, ack, nack>>(rows));
static_assert(proven<rows>);

constexpr std::string_view clients = "load|transit|unload|go_parking|go_node|cancel_transits|send_command|send_inputs|send_cargo_id|cross_granted|idle_processing";
constexpr broken none{"src_type", 0, clients}, unnamed_4{"src_type", 4, clients}, of_gateway{"src_type", 100, clients}, last{"src_type", 999, clients};
constexpr ack of(int type) { return {1, 2, static_cast<order_type>(type), 3}; }

constexpr std::tuple limits{
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
