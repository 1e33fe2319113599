#pragma once
// What can be typed: each order with its words.

#include <optional>
#include <sstream>

#include "link.hpp"

namespace shop {

struct order_help { const char* name; const char* words; };
inline constexpr order_help known_orders[] = {
    {"load", "CART STATION [LEVEL] [CARGO]"}, {"transit", "CART STATION [LEVEL] [CARGO]"}, {"unload", "CART STATION [LEVEL] [CARGO]"},
    {"go_parking", "CART [NODE]"}, {"go_node", "CART NODE"}, {"cancel_transits", "CART"}, {"send_command", "CART TRANSIT COMMAND"},
    {"send_inputs", "CART TRANSIT INPUTS"}, {"send_cargo_id", "CART TRANSIT CARGO"}, {"cross_granted", "CART NODE"},
    {"idle_processing", ""}, {"help", ""}, {"quit", ""},
};

/// The words that begin like `start`.
inline std::vector<std::string> completions(const std::string& start) {
    std::vector<std::string> fitting;
    for (const order_help& o : known_orders)
        if (std::string(o.name).rfind(start, 0) == 0) fitting.emplace_back(o.name);
    return fitting;
}
/// What can be added to `start` without a choice: the rest of the only order that fits, or what all that fit share.
inline std::string completion(const std::string& start) {
    const auto fitting = completions(start);
    if (fitting.empty()) return {};
    std::string shared = fitting[0];
    for (const std::string& f : fitting)
        while (f.rfind(shared, 0) != 0) shared.pop_back();
    return shared.substr(start.size()) + (fitting.size() == 1 ? " " : "");
}

/// Sends the order that `line` spells out. Empty when it was sent, else what is wrong.
inline std::string obey(gate_link& to, const std::string& line) {
    std::istringstream words(line);
    std::string order, a, b;
    std::uint32_t cart = 0, place = 0;
    unsigned level = 0;
    words >> order;
    const auto want = [&](auto&... values) { return static_cast<bool>((words >> ... >> values)); };
    const auto outcome = [&](bool good) { return good ? std::string{} : std::string{"not sent: no connection, or a value out of range"}; };
    if (order == "load" || order == "transit" || order == "unload") {
        if (!want(cart, place)) return order + " CART STATION [LEVEL] [CARGO]";
        words >> level;
        words.clear();
        words >> a;
        const auto l = static_cast<std::uint8_t>(std::min(level, 255U));
        if (order == "load") return outcome(to.send(gateway::load{0, cart, place, 0, l, "", "", trama::text<10>(a)}));
        if (order == "transit") return outcome(to.send(gateway::transit{0, cart, place, 0, l, "", "", trama::text<10>(a)}));
        return outcome(to.send(gateway::unload{0, cart, place, 0, l, "", "", trama::text<10>(a)}));
    }
    if (order == "idle_processing") return outcome(to.send(gateway::idle_processing{}));
    const bool hook = order == "send_command" || order == "send_inputs" || order == "send_cargo_id";
    if (hook && want(cart, a, b)) {
        if (order == "send_command") return outcome(to.send(gateway::send_command{0, cart, trama::text<10>(a), trama::text<10>(b)}));
        if (order == "send_inputs") return outcome(to.send(gateway::send_inputs{0, cart, trama::text<10>(a), trama::text<10>(b)}));
        return outcome(to.send(gateway::send_cargo_id{0, cart, trama::text<10>(a), trama::text<10>(b)}));
    }
    if (!hook && want(cart)) {
        const bool has_place = want(place);
        if (order == "go_parking") return outcome(to.send(gateway::go_parking{0, cart, place}));
        if (order == "cancel_transits") return outcome(to.send(gateway::cancel_transits{0, cart}));
        if (order == "go_node" && has_place) return outcome(to.send(gateway::go_node{0, cart, place}));
        if (order == "cross_granted" && has_place) return outcome(to.send(gateway::cross_granted{0, cart, place}));
    }
    for (const order_help& o : known_orders)
        if (order == o.name) return std::string(o.name) + " " + o.words;
    return order + ": no such order; help lists them";
}

}  // namespace shop
