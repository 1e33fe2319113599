// The limit and the hand-written code that daisy is compared with.
#include "daisy.hpp"

#include "daisy_by_hand.hpp"

namespace trama::bench::daisy_code {

tally walk(bytes_in in) {
    const std::uint8_t* p = in.data();
    const std::uint8_t* const end = p + in.size();
    tally t;
    for (; p < end; p += *p + 1) ++t.messages;
    return {t.messages, in.size(), 0};
}

namespace {

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

std::uint64_t word_of_header(unsigned family, const std::uint8_t* p) { return (family << 8 | p[3]) + p[1] + 3U * p[2]; }

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

}  // namespace

tally framing_machine(bytes_in in) {
    tally t;
    machine m([&](const std::vector<std::uint8_t>& packet) { ++t.messages; t.sum += packet.size(); });
    for (const std::uint8_t b : in) m.feed(b);
    return t;
}
tally framing_pointers(bytes_in in) {
    tally t;
    each_packet(in, [&](const std::uint8_t*, std::size_t size) { ++t.messages; t.sum += size; });
    return t;
}

tally typed_machine(bytes_in in) {
    tally t;
    machine m([&](const std::vector<std::uint8_t>& packet) {
        const std::uint8_t* p = packet.data();
        const unsigned family = by_hand::family_of(p[1], p[2], p[3]);
        by_hand::body message;
        if (!by_hand::decode(family, p[3], p + 4, packet.size() - 5, [&](const auto& body) { message = body; })) return;
        ++t.messages;
        t.sum += word_of_header(family, p) + std::visit(by_hand::summing{}, message);
    });
    for (const std::uint8_t b : in) m.feed(b);
    return t;
}
tally typed_pointers(bytes_in in) {
    tally t;
    each_packet(in, [&](const std::uint8_t* p, std::size_t size) {
        const unsigned family = by_hand::family_of(p[1], p[2], p[3]);
        std::uint64_t sum = 0;
        if (!by_hand::decode(family, p[3], p + 4, size - 5, [&](const auto& body) { sum = by_hand::summing{}(body); })) return;
        ++t.messages;
        t.sum += sum + word_of_header(family, p);
    });
    return t;
}

}  // namespace trama::bench::daisy_code
