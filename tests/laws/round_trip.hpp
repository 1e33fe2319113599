#pragma once
// L3: decode(encode(m)) == m; encode(decode(b)) == b for canonical b; encode after decode is idempotent.

#include <gtest/gtest.h>

#include "laws/listener.hpp"
#include "laws/subject.hpp"

namespace trama::test {

template <class F>
class round_trip : public testing::Test {};
TYPED_TEST_SUITE_P(round_trip);

/// The packet of `units`, which must hold one and no more.
template <class F>
auto only_event(typename F::decoder& decoder, std::span<const typename F::unit> units) {
    auto e = decoder.next(units);
    if (e.code == errc::need_more) {
        decoder.finish();
        e = decoder.next(units);
    }
    return e;
}

template <class F, class M>
void check(std::uint64_t seed, manners how) {
    rng random(seed);
    memory views;
    const M m = random_message<M>(random, how, views);
    const auto envelope = subject<F>::template random_envelope<M>(random, how);
    SCOPED_TRACE(testing::Message() << M::name << ", seed " << seed << ", " << text_of([&](text_sink& out) { print_fields(out, m, notation::json); }));
    std::array<typename F::unit, F::max_units> wire{}, strict{};
    const auto size = F::encode_unchecked(envelope, m, wire);
    ASSERT_TRUE(size) << "even the unchecked encoder refuses it";
    EXPECT_EQ(*size, F::encoded_size(m));
    bool valid = is_valid(m);
    EXPECT_EQ(valid, validate(m).empty());
    F::for_each_violation(envelope, m, [&](const violation&) { valid = false; });
    if (how == manners::valid) { EXPECT_TRUE(valid); }
    const auto checked = F::encode(envelope, m, strict);
    EXPECT_EQ(bool(checked), valid);
    if (valid) { EXPECT_EQ(strict, wire); }
    else { EXPECT_EQ(checked.code(), errc::out_of_range); }

    typename F::decoder decoder;
    const auto e = only_event<F>(decoder, std::span<const typename F::unit>(wire).first(*size));
    ASSERT_EQ(e.code, errc::ok) << show<F>(std::span<const typename F::unit>(wire).first(*size));
    EXPECT_EQ(e.packet.envelope(), envelope);
    const auto back = decode<M>(e.packet);
    ASSERT_TRUE(back);
    EXPECT_TRUE(*back == m);
    M reused{};
    EXPECT_FALSE(decode_into(e.packet, reused));
    EXPECT_TRUE(reused == m);
    std::array<typename F::unit, F::max_units> again{};
    ASSERT_TRUE(F::encode_unchecked(e.packet.envelope(), *back, again));
    EXPECT_EQ(again, wire) << "canonical bytes come back as they were";

    const M blank{};
    std::array<typename F::unit, F::max_units> without{};
    if (F::encode_unchecked(envelope, blank, without)) { EXPECT_EQ(m == blank, without == wire) << "equal messages have equal bytes, others do not"; }
}

TYPED_TEST_P(round_trip, every_message_comes_back) {
    for (const manners how : {manners::valid, manners::wild})
        TypeParam::messages::each([&]<class M>() {
            for (std::uint64_t seed = 1; seed != 41 && !this->HasFailure(); ++seed) check<TypeParam, M>(seed, how);
        });
}

TYPED_TEST_P(round_trip, a_buffer_one_unit_too_small_is_refused_and_left_alone) {
    rng random(7);
    memory views;
    TypeParam::messages::each([&]<class M>() {
        const M m = random_message<M>(random, manners::valid, views);
        const auto envelope = subject<TypeParam>::template random_envelope<M>(random, manners::valid);
        std::vector<typename TypeParam::unit> out(TypeParam::encoded_size(m) - 1), blank = out;
        EXPECT_EQ(TypeParam::encode(envelope, m, out).code(), errc::buffer_too_small) << M::name;
        EXPECT_EQ(TypeParam::encode_unchecked(envelope, m, out).code(), errc::buffer_too_small) << M::name;
        EXPECT_EQ(out, blank) << M::name;
    });
}

TYPED_TEST_P(round_trip, encoding_what_was_decoded_is_idempotent) {
    std::size_t checked = 0;
    for (std::uint64_t seed = 1; seed != 101; ++seed) {
        rng random(seed);
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const auto stream = subject<TypeParam>::random_stream(random, traffic::damaged, 400);
        typename TypeParam::decoder decoder = subject<TypeParam>::make_decoder();
        read<TypeParam>(decoder, std::span<const typename TypeParam::unit>(stream), [&](const auto& e) {
            if (e.code != errc::ok) return;
            (void)visit<TypeParam>(e.packet, [&]<class M>(const M& m) {
                std::array<typename TypeParam::unit, TypeParam::max_units> once{}, twice{};
                const auto size = TypeParam::encode_unchecked(e.packet.envelope(), m, once);
                ASSERT_TRUE(size) << "what was decoded cannot be encoded";
                typename TypeParam::decoder fresh;
                const auto second = only_event<TypeParam>(fresh, std::span<const typename TypeParam::unit>(once).first(*size));
                if (second.code != errc::ok) return;  // a daisy packet that a decoder without a past does not trust
                const auto back = decode<M>(second.packet);
                ASSERT_TRUE(back);
                EXPECT_TRUE(*back == m);
                ASSERT_TRUE(TypeParam::encode_unchecked(e.packet.envelope(), *back, twice));
                EXPECT_EQ(once, twice);
                ++checked;
            });
        });
    }
    EXPECT_GT(checked, 100U);
}

TYPED_TEST_P(round_trip, a_packet_is_no_other_message) {
    rng random(3);
    for (int i = 0; i != 200; ++i) {
        const auto units = random_units<TypeParam>(random, manners::valid);
        typename TypeParam::decoder decoder;
        const auto e = only_event<TypeParam>(decoder, units);
        ASSERT_EQ(e.code, errc::ok);
        std::size_t accepted = 0;
        TypeParam::messages::each([&]<class M>() {
            const auto m = decode<M>(e.packet);
            accepted += m ? 1U : 0U;
            if (!m) { EXPECT_EQ(m.code(), errc::unknown_message); }
        });
        EXPECT_EQ(accepted, 1U);
    }
}

REGISTER_TYPED_TEST_SUITE_P(round_trip, every_message_comes_back, a_buffer_one_unit_too_small_is_refused_and_left_alone, encoding_what_was_decoded_is_idempotent, a_packet_is_no_other_message);

}  // namespace trama::test
