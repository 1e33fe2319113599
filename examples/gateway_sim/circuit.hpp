#pragma once
// Carts that run round a ring of nodes and execute their transits.

#include "common/process.hpp"
#include "trama/gateway/server.hpp"

namespace circuit {

using namespace example;
namespace gateway = trama::gateway;

inline constexpr std::size_t most_carts = 64;
using server = gateway::server<most_carts>;

class traffic {
public:
    /// Carts 1..`carts` on `nodes` nodes; a segment takes `pace` milliseconds. `crossing` is a node where a cart waits for
    /// cross_granted, 0 for none.
    traffic(server& s, std::size_t carts, std::uint32_t nodes, std::uint64_t pace, std::uint32_t crossing, capture& journal)
        : server_(s), nodes_(nodes), pace_(pace), crossing_(crossing), journal_(journal) {
        for (std::uint32_t id = 1; id <= carts; ++id) {
            gateway::cart_state& c = s.carts().add(id)->state;
            c.ini_node = id % nodes;
            enter(c, (c.ini_node + 1) % nodes);
        }
        gateway::circuit_state all{};
        all.circuit_voltage = 482;
        all.circuit_current = 31;
        all.working_carts = static_cast<std::uint32_t>(carts);
        all.mode = all.target_mode = gateway::circuit_mode::automatic;
        s.set_circuit(all);
        began_.resize(carts, 0);
    }

    /// Time goes by.
    void run(std::uint64_t now) {
        if (now - last_ < step) return;
        last_ = now;
        const bool tell = ++steps_ % 5 == 0;
        for (std::size_t i = 0; i != server_.carts().size(); ++i) move(server_.carts()[i], i, now, tell);
    }
    std::uint64_t done() const { return done_; }

private:
    static constexpr std::uint64_t step = 20;

    void enter(gateway::cart_state& c, std::uint32_t end) {
        c.rel_position = 0;
        c.end_node = end;
        c.next_node = (end + 1) % nodes_;
        c.cross_confirmation_needed = crossing_ != 0 && end == crossing_ ? 1 : 0;
    }
    std::uint32_t target_of(const gateway::transit_order& o) const {
        const bool to_node = o.type == gateway::order_type::go_node || o.type == gateway::order_type::go_parking;
        return (to_node ? o.node : o.station_id) % nodes_;
    }
    void move(gateway::cart& c, std::size_t i, std::uint64_t now, bool tell) {
        const gateway::transit_order* current = c.slots.find(gateway::order_use::current);
        const bool under_way = current != nullptr && current->phase != gateway::transit_phase::transit_done;
        c.state.speed_mms = 0;
        if (!under_way) return;
        if (current->phase == gateway::transit_phase::transiting) {
            if (now - began_[i] < pace_) return;
            finish(c, *current);
        } else if (c.state.ini_node == target_of(*current) && c.state.rel_position == 0) {
            began_[i] = now;
            c.slots.advance(gateway::transit_phase::transiting);
            c.changed = true;
        } else {
            drive(c.state);
            c.changed = c.changed || tell;
        }
    }
    void drive(gateway::cart_state& c) {
        const auto on = static_cast<unsigned>(std::max<std::uint64_t>(1, 100 * step / std::max<std::uint64_t>(pace_, 1)));
        c.speed_mms = 800;
        c.rel_position = static_cast<std::uint16_t>(std::min(100U, c.rel_position + on));
        if (c.rel_position != 100 || c.cross_confirmation_needed != 0) return;
        c.ini_node = c.end_node;
        enter(c, c.next_node);
    }
    void finish(gateway::cart& c, const gateway::transit_order& current) {
        const std::string cargo(current.cargo_id.view()), transit(current.transit_id.view());
        journal_.line("done " + std::to_string(c.state.cart_id) + " " + transit + " " + cargo + "\n");
        const auto status = current.type == gateway::order_type::unload ? c.state.cart_status & ~gateway::cart_status::loaded : c.state.cart_status | gateway::cart_status::loaded;
        if (current.type == gateway::order_type::load || current.type == gateway::order_type::unload) c.state.cart_status = status;
        c.slots.advance(gateway::transit_phase::transit_done);
        c.changed = true;
        ++done_;
    }

    server& server_;
    std::uint32_t nodes_;
    std::uint64_t pace_;
    std::uint32_t crossing_;
    capture& journal_;
    std::vector<std::uint64_t> began_;
    std::uint64_t last_ = 0, steps_ = 0, done_ = 0;
};

}  // namespace circuit
