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

/// All events of `stream` in chunks of `chunk` units, and where the decoder is when `f` is called; which now and then calls idle or reset.
template <class F>
std::vector<std::string> account_of(std::span<const typename F::unit> stream, std::size_t chunk, std::size_t meddle, auto&& drain) {
    std::vector<std::string> notes;
    auto decoder = subject<F>::make_decoder();
    const auto note = [&](const typename F::event& e) {
        notes.push_back(line_of<F>(e) + ' ' + std::to_string(decoder.counters().packets) + ' ' + std::to_string(decoder.pending()));
        if (meddle == 0 || notes.size() % meddle != 0) return;
        if constexpr (requires { decoder.idle(); }) if (notes.size() % 2 == 0) return decoder.idle();
        decoder.reset();
    };
    while (!stream.empty()) {
        const auto part = stream.first(std::min(chunk, stream.size()));
        stream = stream.subspan(part.size());
        drain(decoder, part, note);
    }
    decoder.finish();
    drain(decoder, stream, note);
    return notes;
}

TYPED_TEST(chunk_invariance, reading_ahead_is_asking_for_one_event_after_the_other) {
    using units = std::span<const typename TypeParam::unit>;
    const auto one_by_one = [](auto& decoder, units in, auto& f) { read<TypeParam>(decoder, in, f); };
    const auto ahead = [](auto& decoder, units in, auto& f) { read_ahead<TypeParam>(decoder, in, f); };
    for (const traffic kind : all_traffic)
        for (std::uint64_t seed = first_seed() + 1; seed != first_seed() + 41 && !this->HasFailure(); ++seed) {
            rng random(seed);
            const auto stream = subject<TypeParam>::random_stream(random, kind, 600);
            for (const std::size_t chunk : {stream.size(), std::size_t{1} + random.below(50)})
                for (const std::size_t meddle : {std::size_t{0}, std::size_t{2} + random.below(30)})
                    EXPECT_EQ(first_difference(account_of<TypeParam>(stream, chunk, meddle, one_by_one), account_of<TypeParam>(stream, chunk, meddle, ahead)), "")
                        << name_of(kind) << " traffic, seed " << seed << ", chunks of " << chunk << ", meddling " << meddle << ", stream " << show<TypeParam>(stream);
        }
}

}  // namespace
}  // namespace trama::test
