#pragma once
// A client and a server of gateway, and a connection that a script delays, damages and breaks.
#include "sessions/gateway_client.hpp"
#include "sessions/gateway_server.hpp"

namespace trama::fuzz {

class gateway_session {
    using F = gateway::format;

public:
    /// What is sent is printed where `print` says so; what becomes of it on the line is not in it.
    gateway_session(std::span<const std::uint8_t> script, bool print) : d_(hash_of(script), script), print_(print) {}
    void run() {
        play(d_, [&] {
            step();
            client_.check();
            server_.check();
        });
        settle();
    }

private:
    void step() {
        const std::size_t what = d_.below(16);
        if (what < 3) order();
        else if (what < 6) to_server(1 + d_.below(128));
        else if (what < 9) to_client(1 + d_.below(255));
        else if (what < 11) poll(d_.one_in(16) ? d_.below(gateway::max_record) : gateway::max_record);
        else if (what < 13) server_.work(d_);
        else if (what == 13) wait(d_.one_in(16) ? 1000 : d_.below(40));
        else if (what == 14) client_.damaged |= (d_.one_in(2) ? up_ : down_).damage(d_);
        else if (d_.one_in(2)) reconnect();
        else server_.hear_others(1 + d_.below(20), now_);
    }

    void order() {
        F::messages::at(d_.below(F::messages::count), [&]<class M>() {
            if constexpr (gateway::client_types.allows(static_cast<std::int64_t>(M::key))) {
                arena memory;
                M m = random_message<M>(d_, memory);
                if constexpr (requires { m.cart_id; }) if (!d_.one_in(8)) m.cart_id = static_cast<std::uint32_t>(1 + d_.below(watched_server::carts));
                if constexpr (requires { m.transit_id; }) if (!d_.one_in(4)) m.transit_id = server_.some_transit(d_);
                if constexpr (M::key == gateway::order_type::cross_granted) m.node = static_cast<std::uint32_t>(d_.below(4));
                if (d_.one_in(8)) change_one_value(m, d_, memory);
                put(up_, client_.send(m, now_));
            }
        });
    }
    void put(byte_line& line, std::span<const std::uint8_t> bytes) {
        line.send(bytes);
        if (print_) print_sent<F>(bytes);
    }
    void to_server(std::size_t n) {
        const octets bytes = up_.take(n);
        const exact<std::uint8_t> copy{std::span<const std::uint8_t>(bytes)};
        server_.take(copy.all(), now_, !client_.damaged, d_.one_in(8), [&](const gateway::server_event& e, std::span<const std::uint8_t> reply) {
            client_.replies.push_back({e.type, e.msg_id, e.news == gateway::server_news::accepted, e.transit_id});
            put(down_, reply);
        });
    }
    void to_client(std::size_t n) {
        const octets bytes = down_.take(n);
        const exact<std::uint8_t> copy{std::span<const std::uint8_t>(bytes)};
        client_.listen(copy.all(), now_);
    }
    void poll(std::size_t room = gateway::max_record) {
        const octets state = server_.poll(room);
        if (state.empty()) return;
        client_.states.push_back(state);
        put(down_, state);
    }
    void wait(std::uint64_t by) {
        pass_time(now_, by, d_);
        client_.listen({}, now_);
    }
    void reconnect() {
        up_.under_way.clear();
        down_.under_way.clear();
        client_.lose_connection(now_);
        server_.reconnect(d_.one_in(2));
        client_.damaged = client_.disturbed = false;  // both begin anew
    }
    /// Everything arrives and everybody has time; then a new connection works, whatever the old one went through.
    void settle() {
        while (!up_.under_way.empty()) to_server(100);
        while (!down_.under_way.empty()) to_client(100);
        if (!client_.damaged && !client_.disturbed) require(client_.waiting() == 0, "on a good line every order is answered");
        now_ += 1U << 20;
        client_.listen({}, now_);
        require(client_.waiting() == 0, "no order waits for ever");
        expect_answer("once the line is good an order is answered, whatever came before");
        reconnect();
        for (std::size_t i = 0; i != server_.due(); ++i) poll();
        require(client_.states.size() == server_.due() && server_.poll().empty(), "a new connection is told of everything once");
        expect_answer("a new connection works, whatever the old one went through");
        require(client_.states.empty(), "states arrive");
        client_.check();
        server_.check();
    }
    void expect_answer(const char* what) {
        put(up_, client_.send(gateway::idle_processing{}, now_));
        const auto before = client_.answered();
        to_server(gateway::max_record);
        while (!down_.under_way.empty()) to_client(100);
        require(client_.answered() == before + 1, what);
    }

    dice d_;
    bool print_;
    watched_client client_;
    watched_server server_;
    byte_line up_, down_;
    std::uint64_t now_ = 0;
};

}  // namespace trama::fuzz
