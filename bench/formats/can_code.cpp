// The limit and the hand-written code that can is compared with.
#include "can.hpp"

#include <map>
#include <variant>

#include "can_by_hand.hpp"

namespace trama::bench {

namespace {

using frames_in = unit_span<can::format>;

tally walk(frames_in in) {
    tally t;
    for (const can::frame& f : in) t.sum += f.id + f.length + load_le<std::uint64_t>(f.data.data());
    return {in.size(), t.sum, 0};
}

/// What message `m` adds to the account of `T`.
template <task T, bool Ordered, class M>
void add(account<Ordered>& a, std::uint32_t id, std::size_t frames, const M& m) {
    if constexpr (T == task::framing) return a.packet(frames);
    ++a.messages;
    if constexpr (T == task::selected) {
        if constexpr (std::is_same_v<M, can::actuator_state>) a.words([&](auto&& f) { f(m.actuator); f(m.state); });
    } else {
        a.words([&](auto&& f) {
            f(id);
            f(static_cast<std::uint64_t>(M::key));
            by_hand::words_of(m, f);
        });
        if constexpr (T == task::validated) a.judge(by_hand::valid(m));
    }
}

struct maps {
    struct part { std::vector<std::uint8_t> bytes; std::size_t frames = 0; };
    template <task T, bool Ordered>
    static tally run(frames_in in) {
        using any = std::variant<can::define_function, can::read_sensors, can::sensor_readings, can::read_actuator, can::actuator_state, can::set_actuator, can::set_clock>;
        account<Ordered> a;
        std::map<std::uint32_t, part> parts;
        for (const can::frame& f : in) {
            part& p = parts[f.id];
            p.bytes.insert(p.bytes.end(), f.data.begin(), f.data.begin() + f.length);
            if constexpr (T == task::framing) ++p.frames;
            any message;
            if (!by_hand::finish(p.bytes.data(), p.bytes.size(), [&](const auto& m) { message = m; })) continue;
            std::visit([&](const auto& m) { add<T>(a, f.id, p.frames, m); }, message);
            p.bytes.clear();
            p.frames = 0;
        }
        return a.result();
    }
};

struct slots {
    struct slot { std::uint8_t bytes[24]; std::size_t size = 0, frames = 0; };
    template <task T, bool Ordered>
    static tally run(frames_in in) {
        slot all[3];
        account<Ordered> a;
        for (const can::frame& f : in) {
            if (f.extended || f.remote || f.error || f.fd || f.id < 0x80 || f.id > 0x82) continue;
            slot& s = all[f.id - 0x80];
            if (s.size + f.length > sizeof s.bytes || f.length > 8) { s.size = s.frames = 0; continue; }
            std::memcpy(s.bytes + s.size, f.data.data(), f.length);
            s.size += f.length;
            if constexpr (T == task::framing) ++s.frames;
            if (!by_hand::finish(s.bytes, s.size, [&](const auto& m) { add<T>(a, f.id, s.frames, m); })) continue;
            s.size = s.frames = 0;
        }
        return a.result();
    }
};

}  // namespace

void traits<can::format>::add_limits(race& r, const shared_stream<can::format>& s, task, bool) {
    r.contenders.push_back({"frame walk", "whole", role::limit, s->data.size() * sizeof(can::frame), s->made_of.messages, [s] { return walk(s->data); }});
}

std::span<const by_hand_code<can::format>> traits<can::format>::by_hand() {
    static constexpr by_hand_code<can::format> all[] = {code_of<can::format, maps>("map and vectors"), code_of<can::format, slots>("slots and switch")};
    return all;
}
tally can_read_back(frames_in frames) { return slots::run<task::typed, true>(frames); }

}  // namespace trama::bench
