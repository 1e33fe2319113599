// A circuit's gateway on TCP: takes orders, moves its carts through them, tells their states to the one client that is
// connected. A new connection replaces the one before. Run it with --help.

#include "circuit.hpp"
#include "common/net.hpp"

namespace {

using namespace circuit;

class program {
public:
    explicit program(const options& o)
        : quiet_(o.has("quiet")), to_gateway_(file(o, "to_gateway")), to_client_(file(o, "to_client")), journal_(o.text("journal")),
          traffic_(server_, o.number("carts", 1, most_carts), static_cast<std::uint32_t>(o.number("nodes", 2, 100000)), o.number("pace"), static_cast<std::uint32_t>(o.number("crossing")), journal_) {
        unsigned long port = o.number("port", 0, 65535);
        listener_ = listen_on("127.0.0.1", port);
        poller_.watch(listener_, true, false);
        std::printf("listening on port %lu, %zu carts\n", port, server_.carts().size());
        flush_output();
    }

    void run(std::uint64_t end) {
        while (stopped == 0 && (end == 0 || now() < end)) {
            poller_.wait(10, [&](int fd) {
                if (fd == listener_) take_over();
                else if (fd == client_) receive();
            });
            traffic_.run(now());
            tell();
        }
        const auto& q = server_.quality();
        std::printf("%u connections, %llu orders accepted, %llu refused, %llu transits done, %llu faults, %llu bytes skipped\n", server_.connections(), count(accepted_), count(refused_), count(traffic_.done()), count(q.resynchronisations), count(q.bytes_skipped));
    }

private:
    static constexpr std::size_t most_waiting = 65536;  ///< Bytes for a slow reader; behind them it gets only the latest states.

    static std::string file(const options& o, const char* name) { return o.has("record") ? o.text("record") + "/" + name + ".gateway" : ""; }
    static unsigned long long count(std::uint64_t n) { return n; }

    void take_over() {
        const int fresh = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (fresh < 0) return;
        if (client_ >= 0) hang_up();
        const int yes = 1;
        setsockopt(fresh, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        client_ = fresh;
        session_ = server_.connect();
        say("connection %u", session_);
    }
    void hang_up() {
        close(client_);
        client_ = -1;
        out_.clear();
        server_.disconnect(session_);
    }
    void receive() {
        std::uint8_t in[4096];
        if (out_.size() >= most_waiting) return;  // it must read its replies first
        const ssize_t n = read(client_, in, sizeof in);
        if (n < 0 && (errno == EAGAIN || errno == EINTR)) return;
        if (n <= 0) {
            say("connection %u ends", session_);
            return hang_up();
        }
        to_gateway_.write({in, static_cast<std::size_t>(n)});
        octets reply(gateway::max_record);
        for (std::span<const std::uint8_t> rest(in, static_cast<std::size_t>(n));;) {
            const auto e = server_.next(session_, rest, now(), reply);
            if (e.news == gateway::server_news::need_more) return;
            send(std::span(reply).first(e.written));
            note(e);
        }
    }
    void send(std::span<const std::uint8_t> record) {
        to_client_.write(record);
        out_.add(record);
    }
    /// States go out as the client reads; those it has no time for are replaced by newer ones.
    void tell() {
        if (client_ < 0) return;
        octets out(gateway::max_record);
        while (out_.size() < most_waiting) {
            const std::size_t n = server_.poll(out);
            if (n == 0) break;
            send(std::span(out).first(n));
        }
        if (!out_.flush(client_)) return hang_up();
        poller_.watch(client_, out_.size() < most_waiting, !out_.empty());
    }
    void note(const gateway::server_event& e) {
        using gateway::server_news;
        accepted_ += e.news == server_news::accepted ? 1U : 0U;
        refused_ += e.news == server_news::refused ? 1U : 0U;
        const std::string type(trama::name_of(e.type)), transit(e.transit_id.view());
        if (e.news == server_news::accepted && !transit.empty()) {
            const auto* slot = server_.carts().find(e.cart_id)->slots.find(e.transit_id);
            journal_.line("accepted " + std::to_string(e.cart_id) + " " + transit + " " + std::string(slot->cargo_id.view()) + "\n");
        }
        if (e.news == server_news::accepted) say("order %u: %s for cart %u %s", e.msg_id, type.c_str(), e.cart_id, transit.c_str());
        if (e.news == server_news::refused) say("order %u: %s for cart %u refused: %s", e.msg_id, type.c_str(), e.cart_id, std::string(e.reason).c_str());
    }
    template <class... A>
    void say(const char* format, A... values) const {
        if (quiet_) return;
        std::printf(format, values...);
        std::printf("\n");
        flush_output();
    }

    bool quiet_;
    capture to_gateway_, to_client_, journal_;
    server server_{};
    traffic traffic_;
    poller poller_;
    int listener_ = -1, client_ = -1;
    server::session session_ = 0;
    outbox out_;
    std::uint64_t accepted_ = 0, refused_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    options o("gateway_sim: the gateway of a circuit, with its carts, on TCP\n");
    o.add("port", "N", "port on 127.0.0.1, 0: any that is free", "30000");
    o.add("carts", "N", "carts, 1..64", "4");
    o.add("nodes", "N", "nodes of the circuit, in a ring, 2..100000", "12");
    o.add("pace", "MS", "milliseconds for a segment and for the work at a station", "400");
    o.add("crossing", "NODE", "carts wait for cross_granted before this node, 0: nowhere", "0");
    o.add("seconds", "N", "stop after N seconds, 0: on Ctrl-C", "0");
    o.add("record", "DIR", "write what comes and goes to DIR/to_gateway.gateway and DIR/to_client.gateway");
    o.add("journal", "FILE", "write a line for each transit accepted and each one done");
    o.add("quiet", "", "print no orders");
    o.parse(argc, argv);
    catch_signals();
    program(o).run(o.number("seconds") != 0 ? now() + 1000 * o.number("seconds") : 0);
    return finish(0);
}
