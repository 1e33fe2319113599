#pragma once
// A line that repeats a schedule and suffers one fault; what a decoder makes of it.

#include <gtest/gtest.h>

#include <cstdio>

#include "daisy/schedules.hpp"

namespace trama::test {

/// A packet as it was sent.
struct sent {
    std::size_t at;
    std::size_t size;
    bool documented;
};

/// What one fault, or joining a running line, came to.
struct outcome {
    std::size_t lost = 0;       ///< Intact packets that were not delivered.
    std::size_t invented = 0;   ///< Packets delivered that were never sent.
    std::size_t back = 0;       ///< Bytes from the fault to the first packet from which on none was lost.
    std::size_t late = 0;       ///< Documented packets lost that began at the bound or behind it.
};

/// Sums of outcomes.
struct tally {
    std::size_t faults = 0, lost = 0, most_lost = 0, invented = 0, back = 0, most_back = 0;

    void add(const outcome& o) {
        ++faults;
        lost += o.lost;
        invented += o.invented;
        back += o.back;
        most_lost = std::max(most_lost, o.lost);
        most_back = std::max(most_back, o.back);
    }
    void print(std::string_view name, std::string_view kind) const {
        const auto each = [&](std::size_t n) { return faults == 0 ? 0.0 : static_cast<double>(n) / static_cast<double>(faults); };
        std::printf("%-34.*s %-9.*s %9zu faults, lost %5.3f (at most %zu), invented %6.4f, back in step after %5.1f bytes (at most %zu)\n", static_cast<int>(name.size()), name.data(),
                    static_cast<int>(kind.size()), kind.data(), faults, each(lost), most_lost, each(invented), each(back), most_back);
    }
};

inline bool is_documented(std::span<const std::uint8_t> packet) { return daisy::judge_header(packet, 0, std::min<std::size_t>(packet.size(), 5)) == daisy::header::documented; }

/// A stretch of a running line.
class faulty_line {
public:
    static constexpr std::size_t bound = 256;

    /// `size` bytes of the schedule or a little more, from the start of a cycle.
    faulty_line(const schedule& s, std::size_t size) {
        while (bytes_.size() < size)
            for (std::size_t i = 0; i != s.starts.size(); ++i) {
                const std::size_t end = i + 1 != s.starts.size() ? s.starts[i + 1] : s.cycle.size();
                const auto packet = std::span(s.cycle).subspan(s.starts[i], end - s.starts[i]);
                packets_.push_back({bytes_.size(), packet.size(), is_documented(packet)});
                bytes_.insert(bytes_.end(), packet.begin(), packet.end());
            }
    }
    /// The byte at `at` becomes `value`.
    void corrupt(std::size_t at, std::uint8_t value) { bytes_[at] = value; }
    std::uint8_t operator[](std::size_t at) const { return bytes_[at]; }
    /// The packet that holds the byte at `at` is damaged.
    void break_packet(std::size_t at) {
        std::erase_if(packets_, [&](const sent& p) { return p.at <= at && at < p.at + p.size; });
    }
    /// The first `n` bytes were sent before anybody listened.
    void join(std::size_t n) {
        std::erase_if(packets_, [&](const sent& p) { return p.at < n; });
        bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(n));
        for (sent& p : packets_) p.at -= n;
    }
    void lose(std::size_t at) {
        break_packet(at);
        bytes_.erase(bytes_.begin() + static_cast<std::ptrdiff_t>(at));
        for (sent& p : packets_) p.at -= p.at > at ? 1 : 0;
    }
    /// Before the byte at `at`; between two packets it damages neither.
    void insert(std::size_t at, std::uint8_t value) {
        std::erase_if(packets_, [&](const sent& p) { return p.at < at && at < p.at + p.size; });
        bytes_.insert(bytes_.begin() + static_cast<std::ptrdiff_t>(at), value);
        for (sent& p : packets_) p.at += p.at >= at ? 1 : 0;
    }

    /// Feeds the line to a copy of `decoder` and compares. `fault` is the last damaged byte.
    outcome run(daisy::decoder decoder, std::size_t fault) const {
        outcome o;
        std::size_t next = 0;
        o.back = 0;
        const auto missed = [&](const sent& p) {
            ++o.lost;
            o.back = p.at + p.size > fault ? p.at + p.size - fault : 0;
            if (p.documented && p.at >= fault + bound) ++o.late;
        };
        const std::uint64_t base = decoder.offset() + decoder.pending();
        std::span<const std::uint8_t> in = bytes_;
        read<daisy::format>(decoder, in, [&](const daisy::event& e) {
            if (e.code != errc::ok && e.code != errc::unknown_message) return;
            while (next != packets_.size() && base + packets_[next].at < e.offset) missed(packets_[next++]);
            if (next != packets_.size() && base + packets_[next].at == e.offset && packets_[next].size == e.length) ++next;
            else if (e.offset + e.length > base) ++o.invented;
        });
        const std::uint64_t known = decoder.offset() - base;
        for (; next != packets_.size() && packets_[next].at + packets_[next].size <= known; ++next) missed(packets_[next]);
        // What is still pending at the end counts as lost only if it lies beyond doubt behind the bound.
        for (; next != packets_.size(); ++next)
            if (packets_[next].at + bound + daisy::max_packet < bytes_.size()) missed(packets_[next]);
        return o;
    }

private:
    octets bytes_;
    std::vector<sent> packets_;
};

/// A decoder that has read `before`.
inline daisy::decoder decoder_after(std::span<const std::uint8_t> before) {
    daisy::decoder d;
    read<daisy::format>(d, before, [](const daisy::event&) {});
    return d;
}

/// The schedule's bytes, `cycles` times, without the first `skipped`.
inline octets repeated(const schedule& s, std::size_t cycles, std::size_t skipped = 0) {
    octets all;
    for (std::size_t i = 0; i != cycles; ++i) append(all, s.cycle);
    all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(skipped));
    return all;
}

}  // namespace trama::test
