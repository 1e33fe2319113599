#pragma once
// TCP for the gateway's two examples.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include <optional>

#include "common/process.hpp"

namespace example {

/// `port` 0..65535.
inline sockaddr_in address_of(const std::string& host, unsigned long port) {
    sockaddr_in a{};
    a.sin_family = AF_INET;
    a.sin_port = htons(static_cast<std::uint16_t>(port));
    if (inet_pton(AF_INET, host.c_str(), &a.sin_addr) != 1) refuse(host + " is no IPv4 address");
    return a;
}
/// A listening socket; `port` 0 takes a free one and says which.
inline int listen_on(const std::string& host, unsigned long& port) {
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int yes = 1;
    setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in a = address_of(host, port);
    if (fd < 0 || bind(fd, reinterpret_cast<sockaddr*>(&a), sizeof a) != 0 || listen(fd, 64) != 0) die("cannot listen on port " + std::to_string(port));
    socklen_t size = sizeof a;
    getsockname(fd, reinterpret_cast<sockaddr*>(&a), &size);
    port = ntohs(a.sin_port);
    return fd;
}
/// A socket on its way to a connection, which `poll` shows as writable when it is there or has failed; -1 when there is no
/// way at all. A peer that goes silent, as behind a pulled cable, counts as gone after some ten seconds.
inline int connect_to(const sockaddr_in& a) {
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (fd < 0) return -1;
    const auto set = [&](int level, int name, int value) { setsockopt(fd, level, name, &value, sizeof value); };
    set(IPPROTO_TCP, TCP_NODELAY, 1);
    set(SOL_SOCKET, SO_KEEPALIVE, 1);
    set(IPPROTO_TCP, TCP_KEEPIDLE, 5);
    set(IPPROTO_TCP, TCP_KEEPINTVL, 2);
    set(IPPROTO_TCP, TCP_KEEPCNT, 3);
    set(IPPROTO_TCP, TCP_USER_TIMEOUT, 11000);  // the same for bytes under way, during which no keep-alive is sent
    if (connect(fd, reinterpret_cast<const sockaddr*>(&a), sizeof a) == 0 || errno == EINPROGRESS) return fd;
    close(fd);
    return -1;
}
/// Whether the connection under way is there; nothing when that is open yet.
inline std::optional<bool> connected(int fd) {
    pollfd ready{fd, POLLOUT, 0};
    if (poll(&ready, 1, 0) == 0) return std::nullopt;
    int failed = 0;
    socklen_t size = sizeof failed;
    return getsockopt(fd, SOL_SOCKET, SO_ERROR, &failed, &size) == 0 && failed == 0;
}
/// Which file descriptors have something to say.
class poller {
public:
    poller() : fd_(epoll_create1(EPOLL_CLOEXEC)) { if (fd_ < 0) die("epoll"); }

    /// False for files, which epoll does not watch.
    bool watch(int fd, bool reading, bool writing) {
        epoll_event e{};
        e.events = static_cast<std::uint32_t>((reading ? EPOLLIN : 0U) | (writing ? EPOLLOUT : 0U));
        e.data.fd = fd;
        return epoll_ctl(fd_, EPOLL_CTL_MOD, fd, &e) == 0 || epoll_ctl(fd_, EPOLL_CTL_ADD, fd, &e) == 0;
    }
    void forget(int fd) { epoll_ctl(fd_, EPOLL_CTL_DEL, fd, nullptr); }
    /// Waits at most `patience` milliseconds; calls `f(fd)` for each that is ready.
    void wait(int patience, const std::function<void(int)>& f) {
        epoll_event ready[16];
        const int n = epoll_wait(fd_, ready, 16, patience);
        for (int i = 0; i < n; ++i) f(ready[i].data.fd);
    }

private:
    int fd_;
};

}  // namespace example
