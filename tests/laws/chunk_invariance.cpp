// L1: the events do not depend on how the input was cut. L2 is checked by `listener` at every call on the way.

#include "laws/can_subject.hpp"
#include "laws/daisy_subject.hpp"
#include "laws/gateway_subject.hpp"
#include "laws/listener.hpp"

namespace trama::test {
namespace {

template <class F>
class chunk_invariance : public testing::Test {};
using formats = testing::Types<daisy::format, can::format, gateway::format>;
TYPED_TEST_SUITE(chunk_invariance, formats);

template <class F>
void compare_cuts(traffic kind, std::uint64_t seed) {
    rng random(seed);
    const auto stream = subject<F>::random_stream(random, kind, random.within(1, std::is_same_v<F, can::format> ? 200 : 900));
    std::vector<std::size_t> silences;
    if (random.one_in(3))
        for (std::size_t n = random.within(1, 4); n != 0; --n) silences.push_back(random.below(stream.size() + 1));
    std::sort(silences.begin(), silences.end());
    const auto whole = lines_of<F>(stream, cut::whole, seed, silences);
    for (const cut how : all_cuts) {
        const auto difference = first_difference(whole, lines_of<F>(stream, how, seed, silences));
        EXPECT_EQ(difference, "") << "cut " << name_of(how) << ", stream " << show<F>(stream);
    }
}

TYPED_TEST(chunk_invariance, the_events_of_a_stream_do_not_depend_on_how_it_is_cut) {
    for (const traffic kind : all_traffic)
        for (std::uint64_t seed = first_seed() + 1; seed != first_seed() + 151 && !this->HasFailure(); ++seed) {
            SCOPED_TRACE(testing::Message() << name_of(kind) << " traffic, seed " << seed);
            compare_cuts<TypeParam>(kind, seed);
        }
}

}  // namespace
}  // namespace trama::test
