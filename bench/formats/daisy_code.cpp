// The limit and the hand-written code that daisy is compared with.
#include "daisy.hpp"

#include "daisy_by_hand.hpp"

namespace trama::bench {

namespace {

using bytes_in = unit_span<daisy::format>;

/// From length to length, nothing else.
tally walk(bytes_in in) {
    const std::uint8_t* p = in.data();
    const std::uint8_t* const end = p + in.size();
    std::uint64_t messages = 0;
    for (; p < end; p += *p + 1) ++messages;
    return {messages, static_cast<std::uint64_t>(p - in.data()), 0};
}

/// A byte-wise state machine as it is commonly written: a vector that grows, a callback for each packet.
class machine {
public:
    using callback = std::function<void(const std::vector<std::uint8_t>&)>;
    explicit machine(callback on_packet) : on_packet_(std::move(on_packet)) {}

    void feed(std::uint8_t b) {
        if (packet_.empty() && b < 4) return;
        packet_.push_back(b);
        crc_ = static_cast<std::uint8_t>(crc_ ^ b);
        if (packet_.size() != std::size_t{packet_[0]} + 1) return;
        if (crc_ == 0) on_packet_(packet_);
        packet_.clear();
        crc_ = 0;
    }

private:
    callback on_packet_;
    std::vector<std::uint8_t> packet_;
    std::uint8_t crc_ = 0;
};

/// Calls `f(packet)` for each good packet, pointer to pointer.
template <class F>
void each_packet(bytes_in in, F&& f) {
    const std::uint8_t* p = in.data();
    const std::uint8_t* const end = p + in.size();
    while (p != end) {
        const std::size_t size = std::size_t{*p} + 1;
        if (size < 5 || static_cast<std::size_t>(end - p) < size) { ++p; continue; }
        std::uint8_t crc = 0;
        for (std::size_t i = 0; i != size; ++i) crc = static_cast<std::uint8_t>(crc ^ p[i]);
        if (crc != 0) { ++p; continue; }
        f(p, size);
        p += size;
    }
}

/// What the header of a packet adds to an account, and its body, which `decode(f)` hands to `f(body)`; false if there is none.
template <task T, bool Ordered>
void add(account<Ordered>& a, const std::uint8_t* header, unsigned key, auto&& decode) {
    bool good = true;
    std::uint64_t words = std::uint64_t{header[1]} + header[2] + key;
    if constexpr (Ordered) for (const std::uint64_t word : {std::uint64_t{header[1]}, std::uint64_t{header[2]}, std::uint64_t{key}}) a.sum.add(word);
    const bool known = decode([&](const auto& body) {
        if constexpr (Ordered) by_hand::words_of<true>(body, [&](std::uint64_t word) { a.sum.add(word); });
        else words += by_hand::sum_of(body);
        if constexpr (T == task::validated) good = by_hand::valid(key, body);
    });
    if (!known) return;
    ++a.messages;
    if constexpr (!Ordered) a.sum.add(words);
    if constexpr (T == task::validated) a.judge(good);
}
unsigned key_of(const std::uint8_t* p) { return by_hand::family_of(p[1], p[2], p[3]) << 8 | p[3]; }

/// Direction and speed of a motor, if this is the packet that tells them.
template <bool Ordered>
void add_chosen(account<Ordered>& a, const std::uint8_t* p, std::size_t size) {
    ++a.messages;
    if (size != 8 || key_of(p) != 0x1CB) return;
    a.words([&](auto&& f) {
        f(p[4]);
        f(by_hand::word(by_hand::get<std::int16_t>(p + 5)));
    });
}

struct state_machine {
    template <task T, bool Ordered>
    static tally run(bytes_in in) {
        account<Ordered> a;
        machine m([&](const std::vector<std::uint8_t>& packet) {
            const std::uint8_t* p = packet.data();
            if constexpr (T == task::framing) return a.packet(packet.size());
            if constexpr (T == task::selected) return add_chosen(a, p, packet.size());
            by_hand::body message;
            const unsigned key = key_of(p);
            if (!by_hand::decode(key, p + 4, packet.size() - 5, [&](const auto& body) { message = body; })) return;
            if constexpr (T == task::typed && !Ordered) {  // what the variant holds decides once
                ++a.messages;
                a.sum.add(std::uint64_t{p[1]} + p[2] + key + std::visit([](const auto& body) { return by_hand::sum_of(body); }, message));
            } else {
                add<T>(a, p, key, [&](auto&& f) { return std::visit(f, message), true; });
            }
        });
        for (const std::uint8_t b : in) m.feed(b);
        return a.result();
    }
};
struct pointers {
    template <task T, bool Ordered>
    static tally run(bytes_in in) {
        account<Ordered> a;
        each_packet(in, [&](const std::uint8_t* p, std::size_t size) {
            if constexpr (T == task::framing) return a.packet(size);
            if constexpr (T == task::selected) return add_chosen(a, p, size);
            const unsigned key = key_of(p);
            add<T>(a, p, key, [&](auto&& f) { return by_hand::decode(key, p + 4, size - 5, f); });
        });
        return a.result();
    }
};

}  // namespace

void traits<daisy::format>::add_limits(race& r, const shared_stream<daisy::format>& s, task, bool clean) {
    if (!clean) return;
    r.contenders.push_back({"LEN walk", "whole", role::limit, s->data.size(), s->made_of.messages, [s] { return walk(s->data); }});
    r.answers.push_back({"where the packets end", "LEN walk", "whole", [s] { return walk(s->data); }});
    r.answers.push_back({"where the packets end", "generator", {}, [s] { return tally{s->made_of.messages, s->data.size(), 0}; }});
}

std::span<const by_hand_code<daisy::format>> traits<daisy::format>::by_hand() {
    static constexpr by_hand_code<daisy::format> all[] = {code_of<daisy::format, state_machine>("state machine"), code_of<daisy::format, pointers>("pointers")};
    return all;
}
tally daisy_read_back(bytes_in packets) { return pointers::run<task::typed, true>(packets); }

}  // namespace trama::bench
