#pragma once
// What can be typed: each order with its words.

#include <algorithm>
#include <charconv>
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

/// The words of a line, taken from the front.
class word_list {
public:
    explicit word_list(const std::string& line) {
        std::istringstream in(line);
        for (std::string word; in >> word;) words_.push_back(word);
    }
    bool more() const { return at_ != words_.size(); }
    bool digits() const { return more() && words_[at_].find_first_not_of("0123456789") == std::string::npos; }
    std::string text() { return more() ? words_[at_++] : (good_ = false, std::string{}); }
    std::uint32_t number() {
        const std::string word = text();
        std::uint32_t n = 0;
        const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), n);
        good_ = good_ && failed == std::errc{} && end == word.data() + word.size();
        return n;
    }
    /// Every word was what it had to be, and none is left.
    bool fit() const { return good_ && !more(); }

private:
    std::vector<std::string> words_;
    std::size_t at_ = 0;
    bool good_ = true;
};

/// Sends the order that `line` spells out. Empty when it was sent, else what is wrong.
inline std::string obey(gate_link& to, const std::string& line) {
    word_list words(line);
    const std::string order = words.text();
    const auto known = std::find_if(std::begin(known_orders), std::end(known_orders), [&](const order_help& o) { return order == o.name; });
    if (known == std::end(known_orders)) return order + ": no such order; help lists them";
    const std::string expected = line + ": expected " + order + (*known->words != '\0' ? " " : "") + known->words;
    const auto send = [&](const auto& m) {
        if (!words.fit()) return expected;
        const std::string wrong = to.send(m);
        return wrong.empty() ? wrong : line + ": not sent: " + wrong;
    };
    if (order == "idle_processing") return send(gateway::idle_processing{});
    const std::uint32_t cart = words.number();
    if (order == "cancel_transits") return send(gateway::cancel_transits{0, cart});
    if (order == "go_parking") return send(gateway::go_parking{0, cart, words.more() ? words.number() : 0});
    if (order == "go_node") return send(gateway::go_node{0, cart, words.number()});
    if (order == "cross_granted") return send(gateway::cross_granted{0, cart, words.number()});
    if (order == "load" || order == "transit" || order == "unload") {
        const std::uint32_t station = words.number();
        const auto level = static_cast<std::uint8_t>(std::min(words.digits() ? words.number() : 0, 255U));
        const trama::text<10> cargo(words.more() ? words.text() : std::string{});
        if (order == "load") return send(gateway::load{0, cart, station, 0, level, "", "", cargo});
        if (order == "transit") return send(gateway::transit{0, cart, station, 0, level, "", "", cargo});
        return send(gateway::unload{0, cart, station, 0, level, "", "", cargo});
    }
    const trama::text<10> transit(words.text()), what(words.text());
    if (order == "send_command") return send(gateway::send_command{0, cart, transit, what});
    if (order == "send_inputs") return send(gateway::send_inputs{0, cart, transit, what});
    if (order == "send_cargo_id") return send(gateway::send_cargo_id{0, cart, transit, what});
    return expected;  // help and quit, which stand alone
}

}  // namespace shop
