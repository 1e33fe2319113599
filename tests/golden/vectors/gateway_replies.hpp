#pragma once
// Golden vectors of the gateway's replies. [gateway, "Respuestas del gateway"]
// One literal for each field, in the widths of the document's tables; numbers stand right in their columns.
#include "golden/vectors/gateway_row.hpp"

namespace trama::golden::gateway_replies {

using namespace gateway;

inline constexpr table rows{
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

}  // namespace trama::golden::gateway_replies
