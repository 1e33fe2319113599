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

REGISTER_TYPED_TEST_SUITE_P(reference, says_the_same_of_any_stream);

}  // namespace trama::test
