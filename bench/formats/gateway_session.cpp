// A warehouse as one would record it, both ways: carts tell every change unasked, the client gives orders and lets carts
// pass, the gateway accepts or refuses. Message numbers count up, and a cart's states differ by little.
#include "gateway_records.hpp"

namespace trama::bench {

namespace {

using F = gateway::format;
using namespace gateway;

class warehouse {
public:
    warehouse() {
        arena memory;
        for (std::size_t i = 0; i != carts_.size(); ++i) {
            carts_[i] = random_message<cart_state>(d_, memory);
            carts_[i].cart_id = static_cast<std::uint32_t>(i + 1);
        }
    }
    /// What comes next: of 40, 33 states of carts, 1 of the circuit, 6 exchanges.
    void step(stream<F>& s) {
        switch (d_.below(40)) {
            case 0: return tell(s, random<circuit_state>());
            case 1: return order<load>(s);
            case 2: return order<unload>(s);
            case 3: return d_.one_in(3) ? order<transit>(s) : order<go_node>(s);
            case 4: return d_.one_in(3) ? order<cancel_transits>(s) : order<go_parking>(s);
            case 5: return d_.one_in(3) ? order<send_inputs>(s) : order<send_command>(s);
            case 6: return order<cross_granted>(s);
            default: return move(s, carts_[d_.below(carts_.size())]);
        }
    }

private:
    template <class M>
    M random() {
        arena memory;
        return random_message<M>(d_, memory);
    }
    template <class M>
    void tell(stream<F>& s, M m) {
        m.msg_id = from_gateway_;
        from_gateway_ = (from_gateway_ + 1) % 100'000;
        append_record(s, m, d_);
    }
    void move(stream<F>& s, cart_state& cart) {
        cart.rel_position = static_cast<std::uint16_t>(cart.rel_position + d_.below(30));
        if (cart.rel_position > 100) {
            cart.rel_position = 0;
            cart.ini_node = cart.end_node;
            cart.end_node = cart.next_node;
            cart.next_node = static_cast<std::uint32_t>(1 + d_.below(400));
            cart.cart_phase = static_cast<cart_phase>(d_.below(10));
        }
        cart.speed_mms = static_cast<std::int32_t>(d_.below(2000));
        tell(s, cart);
    }
    /// An order and its answer, now and then with a state in between; one in 20 is refused.
    template <class Order>
    void order(stream<F>& s) {
        Order o = random<Order>();
        o.msg_id = from_client_;
        from_client_ = (from_client_ + 1) % 100'000;
        cart_state& cart = carts_[d_.below(carts_.size())];
        o.cart_id = cart.cart_id;
        append_record(s, o, d_);
        if (d_.one_in(3)) move(s, cart);
        constexpr bool makes_transit = Order::key <= order_type::go_node;
        if (d_.one_in(20)) answer<nack>(s, o);
        else if constexpr (makes_transit) answer<transit_ack>(s, o);
        else answer<ack>(s, o);
    }
    template <class Reply, class Order>
    void answer(stream<F>& s, const Order& o) {
        Reply r = random<Reply>();
        r.cart_id = o.cart_id;
        r.src_type = Order::key;
        r.src_msg_id = o.msg_id;
        tell(s, r);
    }

    dice d_{35};
    std::array<cart_state, 24> carts_{};
    std::uint32_t from_gateway_ = 0, from_client_ = 0;
};

}  // namespace

stream<F> gateway_session(std::size_t bytes) {
    warehouse w;
    return make_stream<F>(bytes, 36, [&](auto& s, dice&) { w.step(s); });
}

}  // namespace trama::bench
