#pragma once
// can as a subject of the laws. Times are microseconds, the time-out is a second.

#include <gtest/gtest.h>

#include "laws/subject.hpp"
#include "reference/reference.hpp"
#include "trama/can/format.hpp"

namespace trama::test {

inline constexpr std::uint64_t can_second = 1'000'000;

template <>
struct subject<can::format> {
    using F = can::format;
    using frames = std::vector<can::frame>;

    static can::reassembler make_decoder() { return can::reassembler({can::central_master, can::master_1, can::master_2}, can_second); }
    /// Every frame is one line of the log.
    static std::string head(const can::event& e) {
        return text_of([&](text_sink& out) { out << R"({"protocol":"can","line":)" << e.offset + 1 << ",\"frames\":" << e.length << ",\"id\":" << e.id; });
    }
    static std::span<const std::uint8_t> raw(const can::event& e) { return e.bytes; }
    template <has_layout M>
    static std::string identity(const can::event&) { return ",\"message\":\"" + std::string(M::name) + '"'; }
    static std::string error_tail(const can::event&) { return {}; }
    /// No two events begin at the same frame. (Identifiers interleave, so that events do not tile the log.)
    static void check_place(const can::event& e, std::uint64_t&, std::vector<bool>& seen) {
        if (seen.size() <= e.offset) seen.resize(e.offset + 1);
        EXPECT_FALSE(seen[e.offset]) << "two events begin at frame " << e.offset;
        seen[e.offset] = true;
    }
    template <has_layout M>
    static can::envelope random_envelope(rng& random, manners) { return {static_cast<std::uint32_t>(random.within(0x80, 0x82))}; }

    static std::string show(std::span<const can::frame> units) {
        std::array<char, 64> line;
        std::string log;
        for (const can::frame& f : units) {
            text_sink out(line);
            const auto micros = std::to_string(can_second + f.time % can_second);
            out << '(' << f.time / can_second << '.' << std::string_view(micros).substr(1) << ") can0 ";
            const std::uint32_t id = f.id | (f.error ? 0x20000000U : 0U);
            for (int shift = f.extended || f.error ? 28 : 8; shift >= 0; shift -= 4) out << "0123456789ABCDEF"[id >> shift & 15];
            out << '#';
            if (f.fd) out << "#0";
            if (f.remote) out << 'R';
            else out.hex(std::span(f.data).first(f.length));
            log += out.view();
            log += '\n';
        }
        return log;
    }
    static std::vector<std::string> reference_lines(std::span<const can::frame> units, std::span<const std::size_t> = {}) {
        return trama_reference::can_lines(show(units), 1.0);
    }

    static void change(rng& random, can::frame& f) {
        switch (random.below(6)) {
            case 0: f.length = static_cast<std::uint8_t>(random.below(9)); break;
            case 1: f.id = static_cast<std::uint32_t>(random.within(0x7E, 0x84)); break;
            case 2: f.data[2] = random.one_in(2) ? static_cast<std::uint8_t>(random.within('A', 'Z')) : random.byte(); break;
            default: f.data[random.below(8)] = random.byte();
        }
        for (std::size_t i = f.length; i < f.data.size(); ++i) f.data[i] = 0;
    }
    static can::frame random_frame(rng& random) {
        can::frame f;
        f.id = static_cast<std::uint32_t>(random.within(0x7F, 0x83));
        f.length = static_cast<std::uint8_t>(random.below(9));
        for (std::size_t i = 0; i != f.length; ++i) f.data[i] = random.byte();
        constexpr std::string_view letters = "FRAMCFRAMCFRAMCfXZ";
        if (f.length > 2 && !random.one_in(4)) f.data[2] = static_cast<std::uint8_t>(letters[random.below(letters.size())]);
        switch (random.below(12)) {
            case 0: f.extended = true; break;
            case 1: f.remote = true; f.length = 0; f.data = {}; break;
            case 2: f.error = true; break;
            case 3: f.fd = true; break;
            default: break;
        }
        return f;
    }
    /// Messages of all identifiers at once, each sending its own in order.
    static frames random_stream(rng& random, traffic kind, std::size_t size) {
        std::array<frames, 3> queues;
        frames stream;
        const bool free_noise = kind == traffic::hostile || kind == traffic::damaged;
        while (stream.size() < size) {
            const std::size_t id = random.below(3);
            if (kind == traffic::garbage || (free_noise && random.one_in(4))) {
                stream.push_back(random_frame(random));
                continue;
            }
            if (queues[id].empty()) {
                queues[id] = random_units<F>(random, random.one_in(3) ? manners::wild : manners::valid);
                for (auto& f : queues[id]) f.id = static_cast<std::uint32_t>(0x80 + id);
            }
            stream.push_back(queues[id].front());
            queues[id].erase(queues[id].begin());
        }
        if (free_noise) damage(random, stream, random.below(1 + size / 10), [&](auto& f) { change(random, f); });
        set_times(random, stream, kind != traffic::clean);
        return stream;
    }
    static void set_times(rng& random, frames& stream, bool gaps) {
        std::uint64_t now = 1000 * can_second;
        for (auto& f : stream) {
            now += random.below(1000);
            if (gaps && random.one_in(6)) now += random.one_in(2) ? can_second : random.below(3 * can_second);
            if (gaps && random.one_in(30)) now -= random.below(2 * can_second);
            f.time = now;
        }
    }
};

extern template std::vector<can::format::unit> random_units<can::format>(rng&, manners);
extern template std::string line_of<can::format>(const can::event&);

}  // namespace trama::test
