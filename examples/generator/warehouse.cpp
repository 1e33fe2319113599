#include "capture.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "trama/trama.hpp"

namespace traffic {

namespace {

namespace gateway = trama::gateway;
using gateway::order_type;

constexpr std::size_t before_orders = 1 + 3 + 39;  // STX, type, and the fields of a cart_state up to its orders

class connection {
public:
    std::string run();

private:
    using record = std::array<std::uint8_t, gateway::max_record>;

    template <class M>
    std::size_t make(const M& m, record& out, gateway::justify side) {
        const auto size = gateway::format::encode_unchecked({}, m, out, side);
        if (!size) std::abort();
        return *size;
    }
    template <class M>
    void send(const M& m, gateway::justify side = gateway::justify::right) {
        record out{};
        const std::size_t size = make(m, out, side);
        line_ << std::span<const std::uint8_t>(out).first(size);
    }
    // Gateways of different versions put the spaces on different sides; one of them does not even agree with itself.
    void send_mixed(const gateway::cart_state& state) {
        record head{}, tail{};
        make(state, head, gateway::justify::left);
        const std::size_t size = make(state, tail, gateway::justify::right);
        std::copy(head.begin(), head.begin() + before_orders, tail.begin());
        line_ << std::span<const std::uint8_t>(tail).first(size);
    }
    std::uint32_t client_id() { return client_id_ = (client_id_ + 1) % 100'000; }
    std::uint32_t gateway_id() { return gateway_id_ = (gateway_id_ + 1) % 100'000; }

    template <class Order>
    void order(std::uint32_t cart, std::uint32_t station, std::string_view cargo);
    void state(std::uint32_t cart, int step);
    void circuit(gateway::circuit_mode mode, gateway::circuit_check check);
    void commands();
    void damage();

    numbers random_{48};
    capture line_;
    std::uint32_t client_id_ = 99'990;  // to wrap on the way
    std::uint32_t gateway_id_ = 0;
    int transits_ = 0;
    trama::text<10> transit_;
};

template <class Order>
void connection::order(std::uint32_t cart, std::uint32_t station, std::string_view cargo) {
    Order wanted{};
    wanted.msg_id = client_id();
    wanted.cart_id = cart;
    wanted.station_id = station;
    wanted.station_type = 2;
    wanted.level = static_cast<std::uint8_t>(random_.between(0, 15));
    wanted.options = "FAST";
    wanted.cargo_id = cargo;
    send(wanted, cart % 2 == 0 ? gateway::justify::right : gateway::justify::left);
    transit_ = std::string_view("TR-" + std::to_string(1000 + ++transits_));
    send(gateway::transit_ack{gateway_id(), cart, Order::key, wanted.msg_id, transit_});
}

void connection::state(std::uint32_t cart, int step) {
    const auto node = static_cast<std::uint32_t>(100 * cart) + static_cast<std::uint32_t>(step);
    gateway::cart_state now{};
    now.msg_id = gateway_id();
    now.cart_id = cart;
    now.cart_status = gateway::cart_status::busy | gateway::cart_status::ready | (step > 10 ? gateway::cart_status::loaded : gateway::cart_status::none);
    now.cart_phase = step > 10 ? gateway::cart_phase::go_unload : gateway::cart_phase::go_load;
    now.ini_node = node;
    now.rel_position = static_cast<std::uint16_t>(random_.between(0, 100));
    now.end_node = node + 1;
    now.next_node = node + 2;
    now.speed_mms = step % 8 == 0 ? -random_.between(1, 300) : random_.between(0, 1500);
    now.cross_confirmation_needed = step % 6 == 0;
    gateway::transit_order& current = now.orders[0];
    current.use = gateway::order_use::current;
    current.type = step > 10 ? order_type::unload : order_type::load;
    current.node = node + 9;
    current.station_id = 17;
    current.station_type = 2;
    current.level = static_cast<std::uint8_t>(cart);
    current.options = "FAST";
    current.transit_id = transit_;
    current.cargo_id = "PALLET 7";
    current.phase = gateway::transit_phase::transiting;
    if (cart % 3 == 0) send_mixed(now);
    else send(now, cart % 3 == 1 ? gateway::justify::right : gateway::justify::left);
}

void connection::circuit(gateway::circuit_mode mode, gateway::circuit_check check) {
    gateway::circuit_state now{};
    now.msg_id = gateway_id();
    now.circuit_voltage = static_cast<std::uint16_t>(random_.between(475, 490));
    now.circuit_current = static_cast<std::uint16_t>(random_.between(20, 160));
    now.working_carts = 3;
    now.check = check;
    now.target_mode = gateway::circuit_mode::automatic;
    now.mode = mode;
    send(now);
}

void connection::commands() {
    const auto answered = [&](order_type type, std::uint32_t cart) { send(gateway::ack{gateway_id(), cart, type, client_id_}); };
    send(gateway::send_inputs{client_id(), 2, transit_, "0110"});
    answered(order_type::send_inputs, 2);
    send(gateway::send_cargo_id{client_id(), 2, transit_, "BOX-12"});
    answered(order_type::send_cargo_id, 2);
    send(gateway::send_command{client_id(), 2, transit_, "HOOK \"UP\""});
    answered(order_type::send_command, 2);
    send(gateway::cross_granted{client_id(), 3, 309}, gateway::justify::left);
    answered(order_type::cross_granted, 3);
    send(gateway::go_node{client_id(), 1, 150});
    send(gateway::transit_ack{gateway_id(), 1, order_type::go_node, client_id_, "TR-NODE"});
    send(gateway::cancel_transits{client_id(), 9});
    send(gateway::nack{gateway_id(), 9, order_type::cancel_transits, client_id_, "no such cart on this circuit"});
    send(gateway::idle_processing{client_id()});
    answered(order_type::idle_processing, 0);  // no cart to name [D18]
}

void connection::damage() {
    record out{};
    const std::size_t size = make(gateway::go_parking{client_id(), 2, 0}, out, gateway::justify::right);
    line_ << std::span<const std::uint8_t>(out).first(size - 9);  // cut off: the next record follows at once
    state(1, 7);
    line_ << "\r\nlogin: ";
    line_ << "\x02" "210    1   44NEWER GATEWAY" "\x03";  // a type that the document lacks
    line_ << "\x02" " 10   12  2-1    7" "\x03";          // a sign where digits are due
    line_ << "\x02" "  50    \x07" "1" "\x03";            // a control character
    line_ << "\x02" "200  123" "\x03";                    // the wrong length for its type
    gateway::circuit_state odd{};
    odd.msg_id = gateway_id();
    odd.mode = static_cast<gateway::circuit_mode>(9);  // a mode without a name
    send(odd);
}

std::string connection::run() {
    circuit(gateway::circuit_mode::init, gateway::circuit_check::ok);
    circuit(gateway::circuit_mode::automatic, gateway::circuit_check::ok);
    order<gateway::load>(1, 17, "PALLET 7");
    order<gateway::load>(2, 18, "BOX-11");
    order<gateway::transit>(3, 21, "");
    for (int step = 1; step <= 20; ++step) {
        for (std::uint32_t cart = 1; cart <= 3; ++cart) state(cart, step);
        if (step == 6) commands();
        if (step == 9) damage();
        if (step == 10) order<gateway::unload>(1, 30, "PALLET 7");
        if (step % 7 == 0) circuit(gateway::circuit_mode::automatic, step == 14 ? gateway::circuit_check::door_open | gateway::circuit_check::undervoltage : gateway::circuit_check::ok);
    }
    send(gateway::go_parking{client_id(), 1, 0});
    send(gateway::transit_ack{gateway_id(), 1, order_type::go_parking, client_id_, "TR-PARK"});
    return line_.bytes();
}

}  // namespace

std::string warehouse() { return connection{}.run(); }

}  // namespace traffic
