// The library against the slow second implementation in tests/reference: the same JSON lines for any input.

#include "laws/can_subject.hpp"
#include "laws/daisy_subject.hpp"
#include "laws/gateway_subject.hpp"
#include "laws/listener.hpp"

namespace trama::test {
namespace {

/// Ticks the clock with every frame, as the tool does.
std::vector<std::string> ticked_lines(std::span<const can::frame> frames) {
    listener<can::format> l;
    for (const can::frame& f : frames) {
        l.tick(f.time);
        l.feed_chunk({&f, 1});
    }
    l.finish();
    return l.lines();
}

template <class F>
void compare(traffic kind, std::uint64_t seed) {
    rng random(seed);
    const std::size_t longest = std::is_same_v<F, can::format> ? 120 : random.one_in(4) ? 1500 : 300;
    const auto stream = subject<F>::random_stream(random, kind, random.within(1, longest));
    std::vector<std::size_t> silences;
    if (random.one_in(3))
        for (std::size_t n = random.within(1, 4); n != 0; --n) silences.push_back(random.below(stream.size() + 1));
    std::sort(silences.begin(), silences.end());
    const cut how = all_cuts[random.below(all_cuts.size())];
    std::vector<std::string> lines;
    if constexpr (std::is_same_v<F, can::format>) lines = ticked_lines(stream);
    else lines = lines_of<F>(stream, how, seed, silences);
    const auto difference = first_difference(lines, subject<F>::reference_lines(stream, silences));
    EXPECT_EQ(difference, "") << "silences " << testing::PrintToString(silences) << ", stream " << show<F>(stream);
}

template <class F>
class reference : public testing::Test {};
using formats = testing::Types<daisy::format, can::format, gateway::format>;
TYPED_TEST_SUITE(reference, formats);

TYPED_TEST(reference, says_the_same_of_any_stream) {
    for (const traffic kind : all_traffic)
        for (std::uint64_t seed = first_seed() + 1; seed != first_seed() + 801 && !this->HasFailure(); ++seed) {
            SCOPED_TRACE(testing::Message() << name_of(kind) << " traffic, seed " << seed);
            compare<TypeParam>(kind, seed);
        }
}

}  // namespace
}  // namespace trama::test
