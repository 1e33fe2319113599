#pragma once
// What the harness has to know about can beyond the wire_format concept.
#include "random_message.hpp"
#include "traits.hpp"
#include "trama/can/format.hpp"

namespace trama::fuzz {

template <>
struct traits<can::format> {
    /// Ten octets of input make a frame: how it comes, its DLC, eight of data. `frame_of` says what their bits mean.
    static constexpr std::size_t unit_octets = 10;
    /// A continuation has no header, so a lost frame may swallow the next message's first ones; silence for longer than the
    /// time-out ends that. Without silence there is no bound.
    static constexpr std::size_t recovery_bound = 0;
    static constexpr bool one_spelling = true;  ///< A message has but one body.
    static constexpr std::uint64_t patience = 50;  ///< The time-out that targets which read gaps in time give a reassembler.
    /// Nine values of the DLC octet for each gap in time before a frame: none, 1..15, the time-out, one more, or backwards.
    enum gap : unsigned { none = 0, some = 1, full = 16, past = 20, back = 26, last = 28 };

    /// Bits 0..1 of the first octet: identifier 0x80..0x83, the last of them foreign; bit 2 extended, 3 remote, 4 FD, 5 error,
    /// taken only where bits 6 and 7 are set, so that most frames are of the protocol. Bits 2..6 set, but not 7: the DLC is
    /// the second octet as it is, which no bus delivers but a caller may.
    static can::frame frame_of(std::span<const std::uint8_t> ten, std::uint64_t time) {
        can::frame f{};
        f.id = 0x80U + (ten[0] & 3);
        if (ten[0] >= 0xC0) {
            f.extended = (ten[0] & 4) != 0;
            f.remote = (ten[0] & 8) != 0;
            f.fd = (ten[0] & 16) != 0;
            f.error = (ten[0] & 32) != 0;
        }
        f.length = (ten[0] & 0xFC) == 0x7C ? ten[1] : static_cast<std::uint8_t>(ten[1] % 9);
        std::copy_n(ten.begin() + 2, 8, f.data.begin());
        f.time = time;
        return f;
    }
    static std::vector<can::frame> units_from(std::span<const std::uint8_t> input) {
        std::vector<can::frame> frames;
        for (; input.size() >= unit_octets; input = input.subspan(unit_octets)) frames.push_back(frame_of(input, 0));
        return frames;
    }
    /// As `units_from`, with the gaps in time.
    static std::vector<can::frame> timed_units_from(std::span<const std::uint8_t> input, std::uint64_t timeout) {
        auto frames = units_from(input);
        std::uint64_t now = 1000;
        for (std::size_t i = 0; i != frames.size(); ++i) {
            const unsigned step = input[i * unit_octets + 1] / 9U;
            now = step < full ? now + step : step < past ? now + timeout : step < back ? now + timeout + 1 : now - (now > step ? step : 0);
            frames[i].time = now;
        }
        return frames;
    }
    /// Classic frames as input; data beyond the DLC are none of a frame's.
    static octets octets_from(std::span<const can::frame> frames) {
        octets out;
        for (const auto& f : frames) {
            out.push_back(static_cast<std::uint8_t>(f.id - 0x80U));
            out.push_back(f.length);
            out.insert(out.end(), f.data.begin(), f.data.begin() + std::min<std::size_t>(f.length, f.data.size()));
            out.resize((out.size() + unit_octets - 1) / unit_octets * unit_octets);
        }
        return out;
    }
    static std::vector<can::frame> landmark() { return {}; }
    static bool arrives(std::span<const can::frame>) { return true; }
    /// Whether a frame is one of those that `e` covers, from its offset on.
    static bool belongs(const can::frame& f, const can::event& e) { return f.classic() && f.id == e.id; }
    /// Lets the frame `to` come as `from` did, with the gap in time before it; what a message does not say.
    static void arrive_like(std::span<std::uint8_t> to, std::span<const std::uint8_t> from) {
        to[0] = static_cast<std::uint8_t>((from[0] & 0xFC) | (to[0] & 3));
        to[1] = static_cast<std::uint8_t>(std::min(from[1] / 9U, last - 1U) * 9 + to[1] % 9U);
    }
    /// Changes the gap before a frame, its DLC, identifier or kind; the data stay.
    static void alter_unit(std::span<std::uint8_t> ten, dice& d) {
        const std::size_t kind = d.below(8);
        if ((ten[0] & 0xFC) == 0x7C) ten[0] &= 3;
        if (kind < 3) {
            const std::size_t steps[] = {none, some + d.below(full - some), full, past, past, back + d.below(last - back)};
            ten[1] = static_cast<std::uint8_t>(steps[d.below(6)] * 9 + ten[1] % 9U);
        } else if (kind < 5) {
            ten[1] = static_cast<std::uint8_t>(std::min(ten[1] / 9U, last - 1U) * 9 + d.below(9));
        } else if (kind == 5) {
            ten[0] = static_cast<std::uint8_t>((ten[0] & 0xFC) | ((ten[0] + 1 + d.below(3)) & 3));
        } else if (kind == 6) {
            ten[0] = static_cast<std::uint8_t>(0xC0U | 4U << d.below(4) | (ten[0] & 3U));
        } else {
            ten[0] = static_cast<std::uint8_t>(0x7C | (ten[0] & 3));
            ten[1] = static_cast<std::uint8_t>(9 + d.below(247));
        }
    }
    /// Frames as those of `message`, with `body` as their data.
    static octets with_body(std::span<const std::uint8_t> message, std::span<const std::uint8_t> body) {
        octets out;
        do {
            const auto data = body.first(std::min<std::size_t>(body.size(), 8));
            body = body.subspan(data.size());
            out.insert(out.end(), {message[0], static_cast<std::uint8_t>(data.size())});
            out.insert(out.end(), data.begin(), data.end());
            out.resize((out.size() + unit_octets - 1) / unit_octets * unit_octets);
        } while (!body.empty());
        return out;
    }
    /// The frames as the log that `trama decode can` reads.
    static void print_wire(std::span<const std::uint8_t> input) {
        for (const auto& f : units_from(input)) std::printf("%s\n", log_line(f).c_str());
    }
    static std::string log_line(const can::frame& f) {
        char text[64];
        std::snprintf(text, sizeof text, f.extended || f.error ? "(%llu.%06llu) can0 %08X#" : "(%llu.%06llu) can0 %03X#",
                      static_cast<unsigned long long>(f.time / 1'000'000), static_cast<unsigned long long>(f.time % 1'000'000),
                      static_cast<unsigned>(f.error ? f.id | 0x20000000U : f.id));
        std::string line = text;
        if (f.remote) return line + "R";
        if (f.fd) line += "#0";
        for (std::size_t i = 0; i < f.length && i != f.data.size(); ++i) {
            std::snprintf(text, sizeof text, "%02X", unsigned{f.data[i]});
            line += text;
        }
        return line;
    }

    template <class M>
    static can::envelope envelope_for(dice& d, bool = false) { return {0x80U + static_cast<std::uint32_t>(d.below(3))}; }
    template <class M>
    static bool evident(const can::envelope&, const M&) { return true; }
};

/// can with the gaps in time of its input, and a reassembler that gives up after `patience`.
struct timed_can : can::format {
    struct decoder : can::reassembler {
        constexpr decoder() noexcept : can::reassembler({can::central_master, can::master_1, can::master_2}, traits<can::format>::patience) {}
    };
};
template <>
struct traits<timed_can> : traits<can::format> {
    static std::vector<can::frame> units_from(std::span<const std::uint8_t> input) { return timed_units_from(input, patience); }
    /// As that of can, slowed down so that the targets' time-out is that of `trama decode can`, a second.
    static void print_wire(std::span<const std::uint8_t> input) {
        for (auto f : units_from(input)) {
            f.time *= 1'000'000 / patience;
            std::printf("%s\n", log_line(f).c_str());
        }
    }
};

}  // namespace trama::fuzz
