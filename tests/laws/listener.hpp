#pragma once
// Feeds a decoder in chunks, checks at every call what must hold at every call, and notes what it says.

#include <gtest/gtest.h>

#include <memory>

#include "laws/subject.hpp"

namespace trama::test {

/// How a stream is cut into chunks.
enum class cut { whole, single, zero_and_one, small, large };
inline constexpr std::array all_cuts{cut::whole, cut::single, cut::zero_and_one, cut::small, cut::large};
constexpr std::string_view name_of(cut how) {
    constexpr std::array<std::string_view, 5> names{"whole", "single", "zero and one", "small", "large"};
    return names[static_cast<std::size_t>(how)];
}

/// Other runs of the same tests: `--gtest_random_seed=N` moves all seeds. 0 unless asked for.
inline std::uint64_t first_seed() { return static_cast<std::uint64_t>(GTEST_FLAG_GET(random_seed)) * 1'000'000; }

/// Where two lists of lines begin to differ; empty when they do not.
inline std::string first_difference(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    for (std::size_t i = 0; i != std::max(a.size(), b.size()); ++i) {
        const std::string left = i < a.size() ? a[i] : "nothing", right = i < b.size() ? b[i] : "nothing";
        if (left != right) return "line " + std::to_string(i) + ":\n  " + left + "\n  " + right;
    }
    return {};
}

template <wire_format F>
class listener {
public:
    using unit = typename F::unit;

    explicit listener(std::uint64_t seed = 0) : random_(seed) {}

    /// Feeds `units` cut as `how` says, each chunk from a block of exactly its size.
    void feed(std::span<const unit> units, cut how) {
        while (!units.empty()) {
            const std::size_t n = std::min(units.size(), chunk_size(how, units.size()));
            feed_chunk(units.first(n));
            units = units.subspan(n);
        }
    }
    void feed_chunk(std::span<const unit> chunk) {
        const auto block = std::make_unique<unit[]>(chunk.size());
        std::copy(chunk.begin(), chunk.end(), block.get());
        fed_ += chunk.size();
        pull({block.get(), chunk.size()});
    }
    void idle() {
        if constexpr (requires { decoder_.idle(); }) {
            decoder_.idle();
            pull({});
            EXPECT_EQ(decoder_.pending(), 0U) << "after idle()";
        }
    }
    void tick(std::uint64_t now) {
        if constexpr (requires { decoder_.tick(now); }) {
            decoder_.tick(now);
            pull({});
        }
    }
    void finish() {
        decoder_.finish();
        pull({});
        EXPECT_EQ(decoder_.pending(), 0U) << "after finish()";
    }
    const std::vector<std::string>& lines() const { return lines_; }
    typename F::decoder& decoder() { return decoder_; }
    /// Calls of next() so far.
    std::size_t calls() const { return calls_; }

private:
    std::size_t chunk_size(cut how, std::size_t left) {
        switch (how) {
            case cut::whole: return left;
            case cut::single: return 1;
            case cut::zero_and_one: return zero_ = 1 - zero_;
            case cut::small: return random_.below(7);
            case cut::large: return random_.within(1, 2 * F::max_units);
        }
        return left;
    }
    void pull(std::span<const unit> chunk) {
        std::span<const unit> in = chunk;
        // Each call but the last reports an event of at least one unit, of which there are only so many.
        for (std::size_t left = chunk.size() + 2 * F::max_units + 4;; --left) {
            ASSERT_NE(left, 0U) << "next() makes no progress";
            ++calls_;
            const auto e = decoder_.next(in);
            const std::uint64_t consumed = fed_ - in.size();
            if (e.code != errc::need_more) note(e, chunk);
            ASSERT_EQ(covered_ + decoder_.pending() + decoder_.counters().foreign, consumed) << "units are neither reported nor pending";
            if (e.code == errc::need_more) break;
        }
        ASSERT_TRUE(in.empty()) << "need_more with units left";
        ASSERT_EQ(decoder_.counters(), counted_with_foreign()) << "the counters say something else than the events";
    }
    void note(const auto& e, std::span<const unit> chunk) {
        ASSERT_GT(e.length, 0U);
        ASSERT_TRUE(lies_in(e.bytes, chunk)) << "the event's bytes lie elsewhere";
        if (e.code == errc::ok || e.code == errc::unknown_message) { ASSERT_TRUE(lies_in(e.packet.body(), chunk)) << "the packet lies elsewhere"; }
        subject<F>::check_place(e, place_, seen_);
        covered_ += e.length;
        if (e.code == errc::ok) ++counted_.packets;
        else ++counted_.errors[static_cast<std::size_t>(e.code)];
        if (e.code != errc::ok && e.code != errc::unknown_message) counted_.skipped += e.length;
        lines_.push_back(line_of<F>(e));
    }
    bool lies_in(std::span<const std::uint8_t> view, std::span<const unit> chunk) const {
        const auto inside = [&](const void* from, std::size_t size) {
            const auto* begin = static_cast<const std::uint8_t*>(from);
            return begin <= view.data() && view.data() + view.size() <= begin + size;
        };
        return view.empty() || inside(chunk.data(), chunk.size_bytes()) || inside(&decoder_, sizeof decoder_);
    }
    counters counted_with_foreign() const {
        counters all = counted_;
        all.foreign = decoder_.counters().foreign;
        return all;
    }

    typename F::decoder decoder_ = subject<F>::make_decoder();
    rng random_;
    std::size_t zero_ = 1;
    std::vector<std::string> lines_;
    std::uint64_t fed_ = 0, covered_ = 0, place_ = 0;
    std::vector<bool> seen_;
    std::size_t calls_ = 0;
    counters counted_{};
};

/// What a new decoder says of `units`, with idle() at the places given.
template <wire_format F>
std::vector<std::string> lines_of(std::span<const typename F::unit> units, cut how, std::uint64_t seed, std::span<const std::size_t> idle_at = {}) {
    listener<F> l(seed);
    std::size_t at = 0;
    for (const std::size_t stop : idle_at) {
        l.feed(units.subspan(at, stop - at), how);
        l.idle();
        at = stop;
    }
    l.feed(units.subspan(at), how);
    l.finish();
    return l.lines();
}

/// The units as hex, for the trace of a failure.
template <wire_format F>
std::string show(std::span<const typename F::unit> units) { return subject<F>::show(units); }

}  // namespace trama::test
