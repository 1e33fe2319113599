#pragma once
// The client's connection to the gateway: made anew when it is lost.

#include "common/net.hpp"
#include "trama/core/print.hpp"
#include "trama/gateway/client.hpp"

namespace shop {

using namespace example;
namespace gateway = trama::gateway;

/// Why an order of type M cannot be written: the field and what is wrong with it.
template <class M>
std::string fault_of(trama::error e) {
    char text[80];
    trama::text_sink out(text);
    trama::print_path<M>(out, e.field);
    out << ": " << trama::name_of(e.code);
    return std::string(out.view());
}

class gate_link {
public:
    static constexpr std::size_t most_in_flight = 64;

    gate_link(const sockaddr_in& to, std::uint64_t timeout, const std::string& record)
        : to_(to), client_(timeout),
          sent_(record.empty() ? "" : record + "/sent.gateway"), received_(record.empty() ? "" : record + "/received.gateway") {}
    ~gate_link() {
        for (const int fd : {fd_, fresh_}) if (fd >= 0) close(fd);
    }
    gate_link(const gate_link&) = delete;
    gate_link& operator=(const gate_link&) = delete;

    bool connected() const { return fd_ >= 0; }
    unsigned connections() const { return connections_; }
    /// An order would not be refused for want of a connection or of a place to wait for its reply.
    bool can_send() const { return connected() && client_.in_flight() < most_in_flight; }
    const gateway::client<most_in_flight>& client() const { return client_; }

    /// Empty when the order was sent, else why not.
    template <class M>
    std::string send(const M& order) {
        if (!connected()) return "no connection";
        if (!can_send()) return std::to_string(most_in_flight) + " orders wait for their replies";
        octets out(gateway::max_record);
        const auto size = client_.send(order, now(), out);
        if (!size) return fault_of<M>(size.error());
        sent_.write(std::span(out).first(*size));
        out_.add(std::span(out).first(*size));
        if (!out_.flush(fd_)) lose();
        return {};
    }
    /// Drops the connection; a new one is made soon.
    void reconnect() { lose(); }

    /// One turn of at most `patience` milliseconds; `heard` gets what happened, `other` the events of `also`.
    void work(int patience, int also, const std::function<void(const gateway::client_event&)>& heard, const std::function<void()>& other) {
        if (!connected()) open();
        if (also < 0 && watched_ >= 0) poller_.forget(watched_);
        watched_ = also;
        if (also >= 0 && !poller_.watch(also, true, false)) other();  // a file: always ready
        if (connected()) poller_.watch(fd_, true, !out_.empty());
        bool ready = false;
        poller_.wait(patience, [&](int fd) {
            if (fd == also) other();
            else ready = true;
        });
        std::uint8_t in[8192];
        std::size_t size = 0;
        if (ready && connected()) {
            if (!out_.flush(fd_)) lose();
            const ssize_t n = connected() ? read(fd_, in, sizeof in) : -1;
            if (n > 0) size = static_cast<std::size_t>(n);
            else if (connected() && (n == 0 || (errno != EAGAIN && errno != EINTR))) lose();
        }
        received_.write({in, size});
        for (std::span<const std::uint8_t> rest(in, size);;) {
            const auto e = client_.next(rest, now());
            if (e.news == gateway::client_news::need_more) return;
            heard(e);
            if (!connected()) rest = {};  // an answer found the connection dead: what came over it tells nothing about the next one
        }
    }

private:
    /// Begins a connection, or looks what has become of the one that is on its way.
    void open() {
        if (fresh_ < 0 && now() < retry_at_) return;
        if (fresh_ < 0) {
            fresh_ = connect_to(to_);
            give_up_at_ = now() + 3000;
        }
        const auto there = fresh_ >= 0 ? example::connected(fresh_) : false;
        if (!there && now() < give_up_at_) return;
        if (there.value_or(false)) {
            fd_ = fresh_;
            ++connections_;
        } else {
            if (fresh_ >= 0) close(fresh_);
            retry_at_ = now() + 200;
        }
        fresh_ = -1;
    }
    void lose() {
        if (!connected()) return;
        close(fd_);
        fd_ = -1;
        out_.clear();
        client_.disconnected();
        retry_at_ = now() + 50;
    }

    sockaddr_in to_;
    gateway::client<most_in_flight> client_;
    capture sent_, received_;
    poller poller_;
    outbox out_;
    int fd_ = -1, watched_ = -1;
    int fresh_ = -1;  ///< A connection on its way.
    std::uint64_t retry_at_ = 0, give_up_at_ = 0;
    unsigned connections_ = 0;
};

}  // namespace shop
