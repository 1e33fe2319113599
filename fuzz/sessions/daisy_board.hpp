#pragma once
// What the boards of a session do, and what they have answered.
#include <algorithm>
#include <map>

#include "formats/daisy.hpp"
#include "sessions/script.hpp"
#include "trama/daisy/node.hpp"

namespace trama::fuzz {

/// The bodies of the replies that boards have given, by board and command.
class replies_given {
public:
    template <class M>
    void note(daisy::address from, const M& reply) {
        octets body(body_size(reply));
        store_body(body.data(), reply);
        all_[{from.octet, daisy::command_of(M::key)}].push_back(body);
    }
    /// True also for commands that a board answers without being asked by its handler: those of every family.
    bool holds(daisy::address from, const daisy::packet& p) const {
        if (daisy::family_of(p.key()) == daisy::family::common) return true;
        const auto at = all_.find({from.octet, p.command()});
        const auto body = p.body();
        return at != all_.end() && std::any_of(at->second.begin(), at->second.end(), [&](const octets& b) { return std::equal(b.begin(), b.end(), body.begin(), body.end()); });
    }

private:
    std::map<std::pair<std::uint8_t, std::uint8_t>, std::vector<octets>> all_;
};

/// A board that carries out what it can be asked, and answers as the schema allows; now and then it cannot, where that is allowed.
struct obliging {
    daisy::address self;
    dice* d;
    replies_given* given;
    bool may_refuse;

    template <daisy::request_message M>
    daisy::answer operator()(const M& m, daisy::reply_of<M>& reply) {
        require(is_valid(m), "a board is asked for valid things only");
        if (may_refuse && d->one_in(16)) return static_cast<daisy::answer>(2 + d->below(8));
        if constexpr (!requires { reply.description; }) {
            arena memory;
            reply = random_message<daisy::reply_of<M>>(*d, memory);
            if (d->one_in(32)) change_one_value(reply, *d, memory);
        }
        if (fits_wire(reply)) given->note(self, reply);
        return daisy::answer::done;
    }
};

}  // namespace trama::fuzz
