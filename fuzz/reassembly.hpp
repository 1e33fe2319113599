#pragma once
// CAN frames with gaps in time, foreign frames between them, lost, doubled and in another order.
#include "formats/can.hpp"
#include "recovery.hpp"

namespace trama::fuzz {

/// One event with the identifier and the time it came out at.
struct heard {
    errc code{};
    std::uint64_t offset = 0, length = 0;
    std::uint32_t id = 0;
    octets bytes;
    friend bool operator==(const heard&, const heard&) = default;
};

/// Feeds frames one by one; where `ticking`, time is told before every frame, as the command-line tool does.
inline std::vector<heard> listen(std::span<const can::frame> frames, std::uint64_t timeout, bool ticking) {
    can::reassembler r({can::central_master, can::master_1, can::master_2}, timeout);
    std::vector<heard> all;
    const auto drain = [&](std::span<const can::frame> in) {
        for (std::size_t calls = 16;; --calls) {
            require(calls != 0, "next() makes progress");
            const auto e = r.next(in);
            if (e.code == errc::need_more) break;
            all.push_back({e.code, e.offset, e.length, e.id, {e.bytes.begin(), e.bytes.end()}});
        }
        require(in.empty(), "need_more means that the chunk is used up");
    };
    for (const auto& f : frames) {
        const exact<can::frame> one(std::span<const can::frame>(&f, 1));
        if (ticking) {
            r.tick(f.time);
            drain({});
        }
        drain(one.all());
        require(r.pending() <= 2 * 3, "at most two frames of three identifiers are held");
    }
    r.finish();
    drain({});
    std::uint64_t frames_reported = 0;
    for (const auto& h : all) frames_reported += h.length;
    require(frames_reported + r.counters().foreign == frames.size(), "every frame is in one event or foreign");
    return all;
}

inline int reassembly(std::span<const std::uint8_t> input) {
    using F = can::format;
    constexpr std::uint64_t timeout = traits<F>::patience;
    const auto frames = traits<F>::timed_units_from(input, timeout);
    const auto ticked = listen(frames, timeout, true);
    const auto quiet = listen(frames, timeout, false);

    // A DLC above 8 belongs to no message, whatever it interrupts.
    for (std::size_t i = 0; i != frames.size(); ++i)
        if (frames[i].length > 8 && frames[i].classic() && frames[i].id <= can::master_2)
            require(std::any_of(quiet.begin(), quiet.end(), [&](const auto& h) { return h.code == errc::bad_length && h.offset == i && h.length == 1; }), "a DLC above 8 is bad_length");

    // Identifiers do not touch each other: what one says is the same without the others, place and order aside.
    for (std::uint32_t id = can::central_master; id <= can::master_2; ++id) {
        std::vector<can::frame> own;
        std::copy_if(frames.begin(), frames.end(), std::back_inserter(own), [&](const auto& f) { return f.classic() && f.id == id; });
        const auto alone = listen(own, timeout, false);
        std::vector<heard> among;
        std::copy_if(quiet.begin(), quiet.end(), std::back_inserter(among), [&](const auto& h) { return h.id == id; });
        require(alone.size() == among.size(), "an identifier's events do not depend on the others");
        for (std::size_t i = 0; i != alone.size(); ++i)
            require(alone[i].code == among[i].code && alone[i].bytes == among[i].bytes && alone[i].length == among[i].length, "an identifier's events do not depend on the others");
    }
    // Where time does not run backwards, ticks bring time-outs forward and change nothing else: the same messages are delivered.
    if (std::is_sorted(frames.begin(), frames.end(), [](const auto& x, const auto& y) { return x.time < y.time; })) {
        const auto delivered = [](const std::vector<heard>& events) {
            std::vector<heard> messages;
            std::copy_if(events.begin(), events.end(), std::back_inserter(messages), [](const auto& h) { return h.code == errc::ok; });
            return messages;
        };
        require(delivered(ticked) == delivered(quiet), "ticks do not change which messages are delivered");
    }
    // Recovery: after silence on the bus, every intact message arrives, whatever came before.
    dice d(hash_of(input));
    auto all = frames;
    const auto clean = clean_traffic<F>(d, 6);
    const std::uint64_t later = (all.empty() ? 0 : std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.time < b.time; })->time) + timeout + 1;
    for (auto f : clean.units) {
        f.time = later;
        all.push_back(f);
    }
    std::size_t found = 0;
    for (const auto& h : listen(all, timeout, false))
        if (h.code == errc::ok && h.offset >= frames.size()) {
            require(found != clean.bodies.size() && h.bytes == clean.bodies[found], "after silence, the intact messages arrive and nothing else");
            ++found;
        }
    require(found == clean.bodies.size(), "after silence, every intact message arrives");
    return 0;
}

}  // namespace trama::fuzz
