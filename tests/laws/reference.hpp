#pragma once
// The library against the slow second implementation in tests/reference: the same JSON lines for any input.
// Each format has a source of its own, so that one can be built without the others.

#include <gtest/gtest.h>

#include "laws/listener.hpp"
#include "laws/subject.hpp"

namespace trama::test {

/// Ticks the clock with every frame, as the tool does.
template <class F>
std::vector<std::string> ticked_lines(std::span<const typename F::unit> frames) {
    listener<F> l;
    for (const auto& f : frames) {
        l.tick(f.time);
        l.feed_chunk({&f, 1});
    }
    l.finish();
    return l.lines();
}

template <class F>
void compare(traffic kind, std::uint64_t seed) {
    rng random(seed);
    constexpr bool timed = requires(typename F::unit unit) { unit.time; };
    const std::size_t longest = timed ? 120 : random.one_in(4) ? 1500 : 300;
    const auto stream = subject<F>::random_stream(random, kind, random.within(1, longest));
    std::vector<std::size_t> silences;
    if (random.one_in(3))
        for (std::size_t n = random.within(1, 4); n != 0; --n) silences.push_back(random.below(stream.size() + 1));
    std::sort(silences.begin(), silences.end());
    const cut how = all_cuts[random.below(all_cuts.size())];
    std::vector<std::string> lines;
    if constexpr (timed) lines = ticked_lines<F>(stream);
    else lines = lines_of<F>(stream, how, seed, silences);
    const auto difference = first_difference(lines, subject<F>::reference_lines(stream, silences));
    EXPECT_EQ(difference, "") << "silences " << testing::PrintToString(silences) << ", stream " << show<F>(stream);
}

template <class F>
class reference : public testing::Test {};
TYPED_TEST_SUITE_P(reference);

TYPED_TEST_P(reference, says_the_same_of_any_stream) {
    for (const traffic kind : all_traffic)
        for (std::uint64_t seed = first_seed() + 1; seed != first_seed() + 801 && !this->HasFailure(); ++seed) {
            SCOPED_TRACE(testing::Message() << name_of(kind) << " traffic, seed " << seed);
            compare<TypeParam>(kind, seed);
        }
}

/// What the document allows at its ends, what the wire carries at its own, what has a name, and what lies just outside of each.
template <class W, class V>
std::vector<std::int64_t> ends_of(const rule& r) {
    std::vector<std::int64_t> ends;
    if constexpr (std::is_enum_v<V> || std::integral<V>) {
        std::vector<std::int64_t> marks{r.low, r.high, r.also, W::low, W::high};
        if (r.set != 0) for (std::int64_t v = 0; v != 64; ++v) marks.push_back(v);
        if constexpr (enumerated<V>) for (const auto& named : names(V{})) marks.push_back(static_cast<std::int64_t>(named.value));
        for (const std::int64_t mark : marks)
            for (std::int64_t v = std::max<std::int64_t>(mark, W::low) - 1; v <= std::min<std::int64_t>(mark, W::high) + 1; ++v)
                if (v >= W::low && v <= W::high && W::carries(v)) ends.push_back(v);
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    }
    return ends;
}

TYPED_TEST_P(reference, agrees_about_the_ends_of_every_range) {
    using F = TypeParam;
    rng random(11);
    std::size_t compared = 0;
    // More than once, since some fields decide about the ranges of others.
    for (int round = 0; round != 6; ++round) F::messages::each([&]<class M>() {
        memory views;
        const M clean = random_message<M>(random, manners::valid, views);
        const auto envelope = subject<F>::template random_envelope<M>(random, manners::valid);
        std::vector<std::vector<std::int64_t>> ends;
        each_leaf(clean, [&]<class W>(field_ref at, const auto& v, const rule& own) {
            ends.push_back(ends_of<W, std::remove_cvref_t<decltype(v)>>(rule_in_context(clean, at, own)));
        });
        for (std::size_t leaf = 0; leaf != ends.size(); ++leaf)
            for (const std::int64_t value : ends[leaf]) {
                M m = clean;
                std::size_t i = 0;
                each_leaf(m, [&]<class W>(field_ref, auto& v, const rule&) {
                    using kind = std::remove_cvref_t<decltype(v)>;
                    if constexpr (std::is_enum_v<kind> || std::integral<kind>)
                        if (i == leaf) v = static_cast<kind>(value);
                    ++i;
                });
                std::array<typename F::unit, F::max_units> out{};
                const auto size = F::encode_unchecked(envelope, m, out);
                if (!size) continue;  // a count that the rest of the message does not have
                const auto units = std::span<const typename F::unit>(out).first(*size);
                std::vector<std::string> lines;
                if constexpr (requires { units[0].time; }) lines = ticked_lines<F>(units);
                else lines = lines_of<F>(std::vector(units.begin(), units.end()), cut::whole, 1, {});
                EXPECT_EQ(first_difference(lines, subject<F>::reference_lines(units, {})), "") << M::name << ", " << show<F>(units);
                ++compared;
            }
    });
    EXPECT_GT(compared, 50U);
}

TYPED_TEST_P(reference, a_fresh_message_is_blank) {
    TypeParam::messages::each([&]<class M>() {
        const M m{};
        each_leaf(m, [&]<class W>(field_ref at, const auto& v, const rule&) {
            const std::string name = std::string(M::name) + '.' + text_of([&](text_sink& out) { print_path<M>(out, at); });
            if constexpr (requires { v.columns; }) { EXPECT_EQ(std::string(v.view()), "") << name; }
            else if constexpr (requires { v.bytes(); }) { EXPECT_TRUE(v.empty()) << name; }
            else { EXPECT_EQ(as_number(v), 0) << name; }
        });
    });
}

REGISTER_TYPED_TEST_SUITE_P(reference, says_the_same_of_any_stream, agrees_about_the_ends_of_every_range, a_fresh_message_is_blank);

}  // namespace trama::test
