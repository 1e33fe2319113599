#pragma once
// The bus: SocketCAN where the kernel has it, else a UNIX datagram socket for each member and a hub between them.
// Either way a datagram is one struct can_frame.

#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <deque>

#include "common/faults.hpp"
#include "trama/can/frame.hpp"

namespace greenhouse {

using namespace example;
namespace can = trama::can;

inline std::uint64_t micros() {
    using namespace std::chrono;
    return static_cast<std::uint64_t>(duration_cast<microseconds>(steady_clock::now().time_since_epoch()).count());
}
inline can_frame to_wire(const can::frame& f) {
    can_frame out{};
    out.can_id = f.id;
    out.can_dlc = f.length;
    std::memcpy(out.data, f.data.data(), 8);
    return out;
}
inline can::frame from_wire(const can_frame& f) {
    can::frame in{};
    in.id = f.can_id & CAN_EFF_MASK;
    in.extended = (f.can_id & CAN_EFF_FLAG) != 0;
    in.remote = (f.can_id & CAN_RTR_FLAG) != 0;
    in.error = (f.can_id & CAN_ERR_FLAG) != 0;
    in.length = f.can_dlc;
    std::memcpy(in.data.data(), f.data, 8);
    in.time = micros();
    return in;
}

/// One member's end of the bus.
class port {
public:
    explicit port(int fd) : fd_(fd) { unblock(fd); }

    int fd() const { return fd_; }
    /// False when it has to be tried again later.
    bool send(const can::frame& f) {
        const can_frame out = to_wire(f);
        return write(fd_, &out, sizeof out) == static_cast<ssize_t>(sizeof out);
    }
    /// What has come, after at most `patience` milliseconds.
    std::vector<can::frame> wait(int patience) {
        pollfd ready{fd_, POLLIN, 0};
        poll(&ready, 1, patience);
        std::vector<can::frame> in;
        can_frame one{};
        while (in.size() < 64 && read(fd_, &one, sizeof one) == static_cast<ssize_t>(sizeof one)) in.push_back(from_wire(one));
        return in;
    }

private:
    int fd_;
};

/// A raw socket on a CAN interface, -1 where there is none.
inline int open_can(const std::string& interface) {
    const int fd = socket(PF_CAN, SOCK_RAW, CAN_RAW);
    if (fd < 0) return -1;
    ifreq request{};
    std::strncpy(request.ifr_name, interface.c_str(), IFNAMSIZ - 1);
    sockaddr_can where{};
    where.can_family = AF_CAN;
    const bool found = ioctl(fd, SIOCGIFINDEX, &request) == 0;
    where.can_ifindex = request.ifr_ifindex;
    if (found && bind(fd, reinterpret_cast<sockaddr*>(&where), sizeof where) == 0) return fd;
    close(fd);
    return -1;
}

/// The hub of the UNIX bus: hands every frame to everyone but its sender, with faults, and writes a candump log.
class hub {
public:
    hub(const odds& o, unsigned long seed, const std::string& record) : fate_(o, seed), record_(record), began_(micros()) {}

    /// A new member's end.
    int add() {
        int pair[2];
        if (socketpair(AF_UNIX, SOCK_DGRAM, 0, pair) != 0) die("socketpair");
        unblock(pair[0]);
        ends_.push_back(pair[0]);
        return pair[1];
    }
    /// On SocketCAN the hub only listens and writes the log.
    void listen_to(int fd) {
        unblock(fd);
        ends_.push_back(fd);
    }
    /// Carries what has come within `patience` milliseconds.
    void work(int patience) {
        std::vector<pollfd> ready;
        for (const int fd : ends_) ready.push_back({fd, POLLIN, 0});
        poll(ready.data(), ready.size(), held_.empty() ? patience : 1);
        while (!held_.empty() && held_.front().at <= micros()) {
            deliver(held_.front().from, held_.front().frame);
            held_.pop_front();
        }
        for (const int from : ends_) {
            can_frame one{};
            while (read(from, &one, sizeof one) == static_cast<ssize_t>(sizeof one)) carry(from, one);
        }
    }
    std::uint64_t frames() const { return frames_; }
    std::uint64_t faults() const { return fate_.count(); }

private:
    struct held { int from; can_frame frame; std::uint64_t at; };

    void carry(int from, can_frame one) {
        if (fate_.drops()) return;
        if (fate_.flips() && one.can_dlc != 0) one.data[frames_ % one.can_dlc] ^= fate_.one_bit();
        // Frames behind one that is held up wait as well: a bus does not reorder.
        const std::uint64_t at = fate_.delays() ? micros() + 30000 : held_.empty() ? 0 : held_.back().at;
        const int copies = fate_.doubles() ? 2 : 1;
        for (int i = 0; i != copies; ++i) {
            if (at != 0) held_.push_back({from, one, at});
            else deliver(from, one);
        }
    }
    void deliver(int from, const can_frame& one) {
        ++frames_;
        char line[64];
        const std::uint64_t t = micros() - began_;
        const bool wide = (one.can_id & (CAN_EFF_FLAG | CAN_ERR_FLAG)) != 0, remote = (one.can_id & CAN_RTR_FLAG) != 0;
        // candump keeps the mark of an error frame in the identifier
        const std::uint32_t id = one.can_id & ((one.can_id & CAN_ERR_FLAG) != 0 ? CAN_ERR_MASK | CAN_ERR_FLAG : wide ? CAN_EFF_MASK : CAN_SFF_MASK);
        int n = std::snprintf(line, sizeof line, "(%llu.%06llu) can0 %0*X#%s", static_cast<unsigned long long>(t / 1000000), static_cast<unsigned long long>(t % 1000000),
                              wide ? 8 : 3, id, remote ? "R" : "");
        for (int i = 0; i != one.can_dlc && !remote; ++i) n += std::snprintf(line + n, sizeof line - static_cast<std::size_t>(n), "%02X", one.data[i]);
        record_.line(std::string(line, static_cast<std::size_t>(n)) + "\n");
        for (const int to : ends_) {
            if (to == from) continue;
            if (write(to, &one, sizeof one) < 0) continue;  // a member that does not listen loses frames, as on a bus
        }
    }

    fate fate_;
    capture record_;
    std::uint64_t began_;
    std::uint64_t frames_ = 0;
    std::vector<int> ends_;
    std::deque<held> held_;
};

}  // namespace greenhouse
