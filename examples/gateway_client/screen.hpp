#pragma once
// The terminal: a table of carts at the top, redrawn in place, messages below it, the line being typed at the bottom.

#include <termios.h>

#include <deque>

#include "orders.hpp"

namespace shop {

class screen {
public:
    /// On a terminal: keys come one by one, and the table is drawn.
    screen() : live_(isatty(0) == 1 && isatty(1) == 1) {
        live_ = live_ && tcgetattr(0, &before_) == 0;
        if (!live_) return;
        termios raw = before_;
        raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        tcsetattr(0, TCSANOW, &raw);
        std::printf("\033[2J");
    }
    ~screen() {
        if (!live_) return;
        tcsetattr(0, TCSANOW, &before_);
        std::printf("\n");
    }
    screen(const screen&) = delete;
    screen& operator=(const screen&) = delete;

    /// Someone types and reads here; else orders come from a pipe or a file.
    bool live() const { return live_; }
    /// A message to be read.
    void say(const std::string& text) {
        if (!live_) {
            std::printf("%s\n", text.c_str());
            flush_output();
            return;
        }
        messages_.push_back(text);
        if (messages_.size() > std::size(known_orders)) messages_.pop_front();  // all that help says stays
        changed_ = true;
    }
    void note(const gateway::cart_state& c) {
        carts_[c.cart_id] = c;
        changed_ = true;
    }
    void note(const gateway::circuit_state& c) {
        circuit_ = c;
        changed_ = true;
    }
    /// Takes what was typed; calls `f(line)` for each line, also for one that only the end of a pipe ends. False at the end of the input.
    bool type(const std::function<void(const std::string&)>& f) {
        char keys[256];
        const ssize_t n = read(0, keys, sizeof keys);
        if (n < 0 && (errno == EINTR || errno == EAGAIN)) return true;
        if (n <= 0 && !live_ && !line_.empty()) f(std::exchange(line_, {}));
        if (n <= 0) return false;
        for (ssize_t i = 0; i != n; ++i) {
            const char k = keys[i];
            if (k == '\n' || k == '\r') f(std::exchange(line_, {}));
            else if (!live_) line_ += k;
            else if (k == '\t') complete();
            else if ((k == 127 || k == 8) && !line_.empty()) line_.pop_back();
            else if (k == 4 && line_.empty()) return false;
            else if (k >= 32 && k != 127) line_ += k;
        }
        changed_ = true;
        return true;
    }
    void draw(const gate_link& l) {
        changed_ = changed_ || l.connected() != connected_;
        if (!live_ || !changed_ || now() - drawn_ < 50) return;
        changed_ = false;
        connected_ = l.connected();
        drawn_ = now();
        std::string all = "\033[H";
        const auto row = [&](const std::string& text) { all += text + "\033[K\n"; };
        const auto& q = l.client().quality();
        row(std::string(connected_ ? "connected" : "no connection") + ", circuit " + std::string(trama::name_of(circuit_.mode)) + ", " + std::to_string(circuit_.circuit_voltage / 10) + "." + std::to_string(circuit_.circuit_voltage % 10) +
            " V, " + std::to_string(q.goodput(now())) + " bytes/s, round trip " + std::to_string(q.round_trip.last) + " ms");
        row(" cart  phase         from    at     to  mm/s  first order                     second order");
        for (const auto& [id, c] : carts_) row(row_of(c));
        row("");
        for (const std::string& m : messages_) row(m);
        std::printf("%s\033[K> %s\033[J", all.c_str(), line_.c_str());
        std::fflush(stdout);
    }

private:
    static std::string row_of(const gateway::cart_state& c) {
        char text[160];
        std::snprintf(text, sizeof text, "%5u  %-12s %5u %4u%% %5u %5d  %-30s  %-30s%s", c.cart_id, std::string(trama::name_of(c.cart_phase)).c_str(), c.ini_node, unsigned{c.rel_position}, c.end_node, c.speed_mms,
                      slot(c.orders[0]).c_str(), slot(c.orders[1]).c_str(), c.cross_confirmation_needed != 0 ? " waits" : "");
        return text;
    }
    static std::string slot(const gateway::transit_order& o) {
        if (o.use == gateway::order_use::unused) return "-";
        return std::string(trama::name_of(o.use)) + " " + std::string(trama::name_of(o.type)) + " " + std::string(o.transit_id.view());
    }
    void complete() {
        if (line_.find(' ') != std::string::npos) return;
        const std::string rest = completion(line_);
        line_ += rest;
        if (!rest.empty()) return;
        std::string all;
        for (const std::string& c : completions(line_)) all += c + "  ";
        say(all);
    }

    bool live_;
    bool changed_ = true;
    bool connected_ = false;  ///< As drawn.
    std::uint64_t drawn_ = 0;
    termios before_{};
    std::string line_;
    std::deque<std::string> messages_;
    std::map<std::uint32_t, gateway::cart_state> carts_;
    gateway::circuit_state circuit_{};
};

}  // namespace shop
