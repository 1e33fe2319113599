#include "gateway_records.hpp"
#include "hostile.hpp"
#include "races.hpp"

namespace trama::bench {

namespace {

using F = gateway::format;

/// 85 % cart_state; the others are replies, circuit_state and orders.
void append_any(stream<F>& s, dice& d) {
    using namespace gateway;
    switch (d.below(20)) {
        case 0: return append_random_record<ack>(s, d);
        case 1: return d.one_in(2) ? append_random_record<transit_ack>(s, d) : append_random_record<nack>(s, d);
        case 2: return d.one_in(2) ? append_random_record<circuit_state>(s, d) : append_random_record<load>(s, d);
        default: return append_random_record<cart_state>(s, d);
    }
}
stream<F> mixed(std::size_t bytes) { return make_stream<F>(bytes, 31, append_any); }
stream<F> garbage(std::size_t bytes) {
    stream<F> s;
    dice d(32);
    s.data.resize(bytes);
    for (auto& b : s.data) b = static_cast<std::uint8_t>(d.next());
    return s;
}
stream<F> hostile(std::size_t bytes) { return {hostile_gateway(bytes)}; }

}  // namespace

void add_gateway(std::vector<entry>& all, const scale& sizes) {
    std::vector<workload<F>> kinds{
        {"85 % cart_state", condition::clean, mixed},
        {"garbage", condition::noise, garbage},
        {"hostile", condition::noise, hostile},
    };
    add_session<F>(kinds, gateway_session, 183, 33);  // bytes, about a record
    add_races<F>(all, sizes, kinds);
    add_gateway_encode(all, sizes);
}

}  // namespace trama::bench
