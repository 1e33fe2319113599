// A client of the gateway: a shell for orders, with the carts in a table that is redrawn in place; or, with --orders, a
// courier that delivers so many orders exactly once. Run it with --help.

#include <memory>

#include "courier.hpp"
#include "screen.hpp"

namespace {

using namespace shop;
using gateway::client_news;

std::string words_for(const gateway::client_event& e) {
    const std::string order = std::string(trama::name_of(e.order.type)) + " " + std::to_string(e.order.msg_id) + " for cart " + std::to_string(e.order.cart_id);
    if (e.news == client_news::accepted) {
        const auto m = trama::decode<gateway::transit_ack>(e.packet);
        return order + " accepted" + (m ? ": transit " + std::string(m->transit_id.view()) : "");
    }
    if (e.news == client_news::refused) {
        const auto m = trama::decode<gateway::nack>(e.packet);
        return order + " refused: " + std::string(m ? m->error_message.view() : std::string_view{});
    }
    if (e.news == client_news::timed_out) return order + ": no reply in time";
    if (e.news == client_news::in_doubt) return order + ": the connection was lost before the reply";
    if (e.news == client_news::fault) return "damaged bytes: " + std::string(trama::name_of(e.code)) + ", " + std::to_string(e.skipped);
    return e.news == client_news::stray ? "a reply that nobody waits for" : "a record that the document lacks";
}

}  // namespace

int main(int argc, char** argv) {
    options o("gateway_client: orders for the carts of a gateway, typed or delivered by a courier\n");
    o.add("host", "ADDRESS", "IPv4 address of the gateway", "127.0.0.1");
    o.add("port", "N", "its port", "30000");
    o.add("timeout", "MS", "patience with a reply", "1000");
    o.add("orders", "N", "deliver N orders, each exactly once, and stop; 0: read orders from the keyboard", "0");
    o.add("carts", "N", "carts that the courier uses", "4");
    o.add("prefix", "TEXT", "the courier's cargo_ids begin like this; by default with five random characters, fewer for 100000 orders or more");
    o.add("seconds", "N", "stop after N seconds, 0: on Ctrl-C", "0");
    o.add("record", "DIR", "write what comes and goes to DIR/received.gateway and DIR/sent.gateway");
    o.add("quiet", "", "print the courier's summary only");
    o.parse(argc, argv);
    catch_signals();

    // Whatever is wrong with the options is said before there is a screen.
    gate_link gate(address_of(o.text("host"), o.number("port", 1, 65535)), o.number("timeout"), o.text("record"));
    const unsigned long orders = o.number("orders");
    const std::uint64_t end = o.number("seconds") != 0 ? now() + 1000 * o.number("seconds") : 0;
    const std::string prefix = o.has("prefix") ? o.text("prefix") : courier::any_prefix(orders);
    courier runner(gate, orders, o.number("carts", 1, courier::most_carts), prefix);
    bool open = true;
    {
        screen display;
        const auto show = [&](const gateway::client_event& e) {
            if (orders != 0) runner.heard(e);
            const auto cart = trama::decode<gateway::cart_state>(e.packet);
            const auto circuit = trama::decode<gateway::circuit_state>(e.packet);
            if (cart) display.note(*cart);
            if (circuit) display.note(*circuit);
            if (e.news != client_news::state && !o.has("quiet")) display.say(words_for(e));
        };
        const auto obey_line = [&](const std::string& line) {
            if (line == "quit") { open = false; return; }
            if (line == "help") {
                for (const order_help& h : known_orders) display.say(std::string(h.name) + " " + h.words);
                return;
            }
            if (line.find_first_not_of(" \t") == std::string::npos) return;
            if (const std::string wrong = obey(gate, line); !wrong.empty()) display.say(wrong);
        };
        if (orders != 0 && !o.has("quiet")) display.say("cargo_ids begin with " + prefix);
        bool reading = orders == 0;
        std::deque<std::string> lines;  // from a pipe, which waits until they can be sent; someone at a keyboard is told
        const auto take_line = [&](const std::string& line) {
            if (display.live()) obey_line(line);
            else lines.push_back(line);
        };
        std::uint64_t linger = 0;
        while (stopped == 0 && open && (end == 0 || now() < end) && (orders == 0 || !runner.finished())) {
            if (orders != 0) runner.work();
            const bool listen = reading && (display.live() || (gate.connected() && lines.empty()));
            gate.work(20, listen ? 0 : -1, show, [&] { reading = display.type(take_line); });
            for (; open && !lines.empty() && gate.can_send(); lines.pop_front()) obey_line(lines.front());
            display.draw(gate);
            if (orders == 0 && !reading && lines.empty() && linger == 0) linger = now() + 500;  // the replies to what was piped in
            if (linger != 0 && now() > linger && gate.client().in_flight() == 0) open = false;
        }
    }
    if (orders == 0) return finish(0);
    std::printf("%lu of %lu orders delivered, %lu of them in doubt for a while, %u connections\n", runner.delivered(), orders, runner.doubtful(), gate.connections());
    std::printf(runner.finished() ? "goal reached\n" : "goal missed\n");
    return finish(runner.finished() ? 0 : 1);
}
