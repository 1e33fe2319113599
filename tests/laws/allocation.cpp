// L4: nothing in the library allocates. Every allocating function of this program counts its calls, see counting_allocator.cpp.

#include "laws/can_subject.hpp"
#include "laws/counting_allocator.hpp"
#include "laws/daisy_subject.hpp"
#include "laws/gateway_subject.hpp"

namespace trama::test {
namespace {

template <class F>
class allocation : public testing::Test {
protected:
    std::array<char, 16384> text{};
    std::array<typename F::unit, F::max_units> wire{};
};
using formats = testing::Types<daisy::format, can::format, gateway::format>;
TYPED_TEST_SUITE(allocation, formats);

TEST(allocations, are_counted) {
    const std::size_t before = allocations();
    const octets some(100);
    EXPECT_GT(allocations(), before);
    EXPECT_EQ(some.size(), 100U);
}

TYPED_TEST(allocation, never_happens_while_decoding_validating_printing_and_encoding) {
    for (const traffic kind : all_traffic) {
        rng random(5);
        const auto stream = subject<TypeParam>::random_stream(random, kind, 4000);
        std::size_t events = 0, written = 0;
        const std::size_t before = allocations();
        typename TypeParam::decoder decoder = subject<TypeParam>::make_decoder();
        const auto listen = [&](const auto& e) {
            ++events;
            if (e.code != errc::ok) return;
            (void)visit<TypeParam>(e.packet, [&]<class M>(const M& m) {
                written += to_json(m, this->text).value_or(0) + to_text(m, this->text).value_or(0) + validate(m).size();
                written += TypeParam::encode(e.packet.envelope(), m, this->wire).value_or(0) + TypeParam::encode_unchecked(e.packet.envelope(), m, this->wire).value_or(0);
            });
        };
        read<TypeParam>(decoder, std::span<const typename TypeParam::unit>(stream), listen);
        decoder.finish();
        read<TypeParam>(decoder, std::span<const typename TypeParam::unit>{}, listen);
        decoder.reset();
        EXPECT_EQ(allocations(), before) << name_of(kind);
        EXPECT_GT(events + written, 0U);
    }
}

}  // namespace
}  // namespace trama::test
