// A greenhouse as one would record it: the masters poll their nodes in turn, and the nodes answer.
#include "can.hpp"

namespace trama::bench {

namespace {

using F = can::format;
using namespace can;

constexpr std::uint64_t millisecond = 1000;  // of the frames' clock
constexpr unsigned nodes = 12;

/// One master and what is still to come of its present exchange.
class master {
public:
    explicit master(std::uint32_t id) : id_(id) {}

    bool idle() const { return next_ == exchange_.data.size(); }
    /// Asks the next node something and has it answer.
    void begin(dice& d) {
        exchange_ = {};
        next_ = 0;
        node_ = node_ % nodes + 1;
        message_id_ = static_cast<std::uint8_t>((message_id_ + 1) % 201);
        const auto kind = d.below(20);
        if (kind < 12) ask(read_sensors{}, random<sensor_readings>(d));
        else if (kind < 17) ask(read_actuator{}, random<actuator_state>(d));
        else if (kind < 19) echo(random<set_actuator>(d));
        else echo(random<define_function>(d));
    }
    void set_clocks(dice& d) {
        exchange_ = {};
        next_ = 0;
        echo(random<set_clock>(d));
    }
    /// Puts the next frame on the bus.
    void send(stream<F>& bus, std::uint64_t now) {
        bus.data.push_back(exchange_.data[next_++]);
        bus.data.back().time = now;
        if (next_ != ends_[0].first) return;
        bus.made_of.add(ends_[0].second);
        std::swap(ends_[0], ends_[1]);
    }

private:
    template <class M>
    static M random(dice& d) {
        arena memory;
        return random_message<M>(d, memory);
    }
    template <class Request, class Reply>
    void ask(Request request, Reply reply) {
        put(request, 0);
        put(reply, 1);
    }
    template <class M>
    void echo(const M& m) { ask(m, m); }
    template <class M>
    void put(M& m, std::size_t at) {
        m.node = static_cast<std::uint8_t>(node_);
        m.message_id = message_id_;
        stream<F> one;
        append(one, {id_}, m);
        exchange_.data.insert(exchange_.data.end(), one.data.begin(), one.data.end());
        ends_[at] = {exchange_.data.size(), one.made_of};
    }

    std::uint32_t id_;
    unsigned node_ = 0;
    std::uint8_t message_id_ = 0;
    stream<F> exchange_{};
    std::size_t next_ = 0;
    std::array<std::pair<std::size_t, known>, 2> ends_{};  ///< Where request and reply end, and what they are.
};

}  // namespace

stream<F> can_session(std::size_t bytes) {
    stream<F> bus;
    dice d(24);
    const std::size_t frames = bytes / sizeof(can::frame);
    bus.data.reserve(frames + 64);
    std::array<master, 3> masters{master(central_master), master(master_1), master(master_2)};
    std::uint64_t now = 0, clocks_at = 0;
    while (bus.data.size() < frames) {
        if (now >= clocks_at) {
            masters[0].set_clocks(d);
            clocks_at = now + 60'000 * millisecond;
        }
        masters[1].begin(d);
        masters[2].begin(d);
        // Each sends its own frames in order; who comes first on the bus is a matter of chance.
        while (!(masters[0].idle() && masters[1].idle() && masters[2].idle())) {
            master& one = masters[d.below(3)];
            if (one.idle()) continue;
            now += millisecond + d.below(millisecond);
            one.send(bus, now);
        }
        if (d.one_in(nodes)) now += 900 * millisecond;  // till the next second's round
    }
    return bus;
}

}  // namespace trama::bench
