#pragma once
// The client's connection to the gateway: made anew when it is lost.

#include "common/net.hpp"
#include "trama/gateway/client.hpp"

namespace shop {

using namespace example;
namespace gateway = trama::gateway;

class gate_link {
public:
    gate_link(std::string host, unsigned long port, std::uint64_t timeout, const std::string& record)
        : host_(std::move(host)), port_(port), client_(timeout),
          sent_(record.empty() ? "" : record + "/sent.gateway"), received_(record.empty() ? "" : record + "/received.gateway") {}
    ~gate_link() { if (fd_ >= 0) close(fd_); }
    gate_link(const gate_link&) = delete;
    gate_link& operator=(const gate_link&) = delete;

    bool connected() const { return fd_ >= 0; }
    unsigned connections() const { return connections_; }
    const gateway::client<64>& client() const { return client_; }

    /// False when the order cannot be sent now.
    template <class M>
    bool send(const M& order) {
        if (!connected()) return false;
        octets out(gateway::max_record);
        const auto size = client_.send(order, now(), out);
        if (!size) return false;
        sent_.write(std::span(out).first(*size));
        out_.add(std::span(out).first(*size));
        if (!out_.flush(fd_)) lose();
        return true;
    }
    /// Drops the connection; a new one is made soon.
    void reconnect() { lose(); }

    /// One turn of at most `patience` milliseconds; `heard` gets what happened, `other` the events of `also`.
    void work(int patience, int also, const std::function<void(const gateway::client_event&)>& heard, const std::function<void()>& other) {
        if (!connected() && now() >= retry_at_) open();
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
    void open() {
        fd_ = connect_to(host_, port_);
        retry_at_ = now() + 200;
        if (connected()) ++connections_;
    }
    void lose() {
        if (!connected()) return;
        close(fd_);
        fd_ = -1;
        out_.clear();
        client_.disconnected();
        retry_at_ = now() + 50;
    }

    std::string host_;
    unsigned long port_;
    gateway::client<64> client_;
    capture sent_, received_;
    poller poller_;
    outbox out_;
    int fd_ = -1, watched_ = -1;
    std::uint64_t retry_at_ = 0;
    unsigned connections_ = 0;
};

}  // namespace shop
