#pragma once
// TCP for the gateway's two examples.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "common/process.hpp"

namespace example {

inline sockaddr_in address_of(const std::string& host, unsigned long port) {
    sockaddr_in a{};
    a.sin_family = AF_INET;
    a.sin_port = htons(static_cast<std::uint16_t>(port));
    if (inet_pton(AF_INET, host.c_str(), &a.sin_addr) != 1) die(host + " is no IPv4 address");
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
/// A connected socket, -1 when nobody answers.
inline int connect_to(const std::string& host, unsigned long port) {
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in a = address_of(host, port);
    if (fd >= 0 && connect(fd, reinterpret_cast<const sockaddr*>(&a), sizeof a) == 0) {
        const int yes = 1;
        setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        unblock(fd);
        return fd;
    }
    if (fd >= 0) close(fd);
    return -1;
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
