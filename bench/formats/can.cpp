#include "can.hpp"

#include "hostile.hpp"
#include "races.hpp"

namespace trama::bench {

namespace {

using F = can::format;

/// Messages of all kinds on three identifiers whose frames interleave at random.
stream<F> interleaved(std::size_t bytes) {
    stream<F> s;
    dice d(21);
    std::array<stream<F>, 3> queues;
    std::array<std::size_t, 3> next{};
    const std::size_t frames = bytes / sizeof(can::frame);
    s.data.reserve(frames + 16);
    while (s.data.size() < frames || next != std::array<std::size_t, 3>{}) {
        const std::size_t i = d.below(3);
        auto& queue = queues[i].data;
        if (next[i] == queue.size()) {
            queues[i] = {};
            next[i] = 0;
            if (s.data.size() >= frames) continue;
            const auto id = static_cast<std::uint32_t>(0x80 + i);
            F::messages::at(d.below(F::messages::count), [&]<class M>() {
                arena memory;
                append(queues[i], {id}, random_message<M>(d, memory));
            });
        }
        s.data.push_back(queue[next[i]++]);
        s.data.back().time = s.data.size();
        if (next[i] == queue.size()) s.made_of.add(queues[i].made_of);
    }
    return s;
}

/// Frames of all kinds with anything in them, most of them with a letter that begins a message.
stream<F> garbage(std::size_t bytes) {
    stream<F> s;
    dice d(25);
    s.data.resize(bytes / sizeof(can::frame));
    for (can::frame& f : s.data) {
        f.id = static_cast<std::uint32_t>(0x7F + d.below(5));
        f.length = static_cast<std::uint8_t>(d.below(9));
        for (std::size_t i = 0; i != f.length; ++i) f.data[i] = static_cast<std::uint8_t>(d.next());
        if (f.length > 2 && !d.one_in(4)) f.data[2] = static_cast<std::uint8_t>("FRAMC"[d.below(5)]);
        switch (d.below(24)) {
            case 0: f.extended = true; break;
            case 1: f.remote = true; break;
            case 2: f.error = true; break;
            case 3: f.fd = true; break;
            default: break;
        }
    }
    return s;
}
stream<F> hostile(std::size_t bytes) { return {hostile_can(bytes / sizeof(can::frame))}; }

}  // namespace

void add_can(std::vector<entry>& all, const scale& sizes) {
    std::vector<workload<F>> kinds{
        {"interleaved", condition::clean, interleaved},
        {"garbage", condition::noise, garbage},
        {"hostile", condition::noise, hostile},
    };
    add_session<F>(kinds, can_session, 2, 23);  // frames, two a message
    add_races<F>(all, sizes, kinds);
    add_can_encode(all, sizes);
}

}  // namespace trama::bench
