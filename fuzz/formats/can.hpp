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
    /// As `units_from`, but the upper bits of the DLC octet are a gap in time before the frame: 0, some, or one past `timeout`.
    static std::vector<can::frame> timed_units_from(std::span<const std::uint8_t> input, std::uint64_t timeout) {
        auto frames = units_from(input);
        std::uint64_t now = 1000;
        for (std::size_t i = 0; i != frames.size(); ++i) {
            const unsigned gap = input[i * unit_octets + 1] / 9U;
            now = gap < 16 ? now + gap : gap < 20 ? now + timeout : gap < 26 ? now + timeout + 1 : now - (now > gap ? gap : 0);
            frames[i].time = now;
        }
        return frames;
    }
    static octets octets_from(std::span<const can::frame> frames) {
        octets out;
        for (const auto& f : frames) {
            out.push_back(static_cast<std::uint8_t>(f.id - 0x80U));
            out.push_back(f.length);
            out.insert(out.end(), f.data.begin(), f.data.end());
        }
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

}  // namespace trama::fuzz
