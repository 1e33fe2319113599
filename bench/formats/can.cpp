#include "can.hpp"

#include "limits.hpp"

#include "encode.hpp"

namespace trama::bench {

namespace {

using F = can::format;
using namespace can_code;

/// Messages of all kinds on three identifiers whose frames interleave at random.
shared_stream<F> interleaved(std::size_t bytes) {
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
            queue.clear();
            next[i] = 0;
            if (s.data.size() >= frames) continue;
            append_random(queues[i], d.below(can::messages::count), d);
            for (auto& f : queue) f.id = static_cast<std::uint32_t>(0x80 + i);
            ++s.messages;
        }
        s.data.push_back(queue[next[i]++]);
        s.data.back().time = s.data.size();
    }
    return std::make_shared<stream<F>>(std::move(s));
}

std::span<const std::uint8_t> bytes_of(frames_in in) { return {reinterpret_cast<const std::uint8_t*>(in.data()), in.size_bytes()}; }

void add(std::vector<entry>& all, const std::string& workload, std::size_t bytes, const std::string& task, const std::function<void(race&)>& fill) {
    race r{"can", workload, size_name(bytes), task, {}};
    all.push_back({r.id(), [r, fill]() mutable { fill(r); return r; }});
}

using setpoints = std::array<can::set_actuator, 4>;

std::size_t encode_by_library(std::span<const setpoints> in, std::span<can::frame> out) {
    std::size_t at = 0;
    for (const setpoints& four : in)
        for (const can::set_actuator& m : four)
            if (const auto n = can::encode({can::master_1}, m, out.subspan(at))) at += *n;
    return at;
}
std::size_t encode_by_vectors(std::span<const setpoints> in, std::span<can::frame> out) {
    std::size_t at = 0;
    for (const setpoints& four : in)
        for (const can::set_actuator& m : four) {
            const std::vector<std::uint8_t> data{m.node, m.message_id, 'M', m.actuator, m.state};
            can::frame f{};
            f.id = can::master_1;
            f.length = static_cast<std::uint8_t>(data.size());
            std::copy(data.begin(), data.end(), f.data.begin());
            out[at++] = f;
        }
    return at;
}

std::shared_ptr<const std::vector<setpoints>> random_setpoints(std::size_t bytes) {
    auto all = std::make_shared<std::vector<setpoints>>(bytes / (4 * sizeof(can::frame)));
    dice d(22);
    arena memory;
    for (auto& four : *all)
        for (auto& m : four) m = random_message<can::set_actuator>(d, memory);
    return all;
}

}  // namespace

void add_can(std::vector<entry>& all, const scale& sizes) {
    for (const std::size_t bytes : {sizes.large, sizes.small}) {
        add(all, "interleaved", bytes, "framing", [=](race& r) {
            const auto s = interleaved(bytes);
            add_whole<F>(r, s, "frame walk", role::limit, not_compared, walk);
            add_memory_limits(r, bytes_of(s->data));
            add_library<F>(r, s, framing<F>, {0, 65536, 1460, 64, 32});
        });
        add(all, "interleaved", bytes, "typed", [=](race& r) {
            const auto s = interleaved(bytes);
            add_whole<F>(r, s, "frame walk", role::limit, not_compared, walk);
            add_whole<F>(r, s, "map and vectors", role::baseline, 1, typed_maps);
            add_whole<F>(r, s, "slots and switch", role::baseline, 1, typed_slots);
            add_library<F>(r, s, typed<F>, {0, 65536, 1460, 64, 32});
        });
        add(all, "interleaved", bytes, "validated", [=](race& r) {
            const auto s = interleaved(bytes);
            add_whole<F>(r, s, "frame walk", role::limit, not_compared, walk);
            add_library<F>(r, s, typed<F, true>, {0});
        });
    }
    add(all, "interleaved", sizes.large, "two fields by view", [=](race& r) {
        const auto s = interleaved(sizes.large);
        add_whole<F>(r, s, "frame walk", role::limit, not_compared, walk);
        add_library<F>(r, s, selected<F>, {0});
    });
    for (const auto& [name, one_in] : {std::pair{"session, 0.1 % damaged", 1000}, std::pair{"session, 1 % damaged", 100}})
        add(all, name, sizes.large, "typed", [=, rate = static_cast<std::uint64_t>(one_in)](race& r) {
            const auto s = std::make_shared<stream<F>>(damaged(*interleaved(sizes.large), rate, 2, 23));
            add_whole<F>(r, s, "frame walk", role::limit, not_compared, walk);
            add_library<F>(r, s, typed<F>, {0, 1460});
        });
    race r{"can", "setpoints", size_name(sizes.large), "encode", {}};
    all.push_back({r.id(), [r, bytes = sizes.large]() mutable {
        encoding<setpoints, can::frame> e(r, random_setpoints(bytes), 4, 4);
        e.add("trama", role::library, encode_by_library);
        e.add("vectors", role::baseline, encode_by_vectors);
        return r;
    }});
}

}  // namespace trama::bench
