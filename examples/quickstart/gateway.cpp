// Sends a cart to a station and reads what the gateway answers.
#include <cstdio>

#include "trama/gateway/format.hpp"
using namespace trama;

int main() {
    gateway::load order;
    order.msg_id = 7;
    order.cart_id = 12;
    order.station_id = 301;
    order.cargo_id = "PALLET-9";
    std::array<std::uint8_t, gateway::max_record> out;
    const auto size = gateway::encode(order, out);  // refused, with the field's name, if a value is out of range
    if (!size) return 1;
    std::printf("order: %.*s\n", static_cast<int>(*size - 2), reinterpret_cast<const char*>(out.data() + 1));

    constexpr char socket[] = "\x02" "100   31   12  1    7T-000451  " "\x03";
    std::span<const std::uint8_t> in(reinterpret_cast<const std::uint8_t*>(socket), sizeof socket - 1);
    gateway::decoder decoder;
    const auto event = decoder.next(in);
    if (const auto reply = decode<gateway::transit_ack>(event.packet)) {
        const std::string_view transit = reply->transit_id.view();  // without the spaces that fill the field
        std::printf("order %u is transit %.*s\n", reply->src_msg_id, static_cast<int>(transit.size()), transit.data());
    }
}
