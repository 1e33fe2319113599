#include "trama/core/view.hpp"

#include <gtest/gtest.h>

#include "laws/can_subject.hpp"
#include "laws/daisy_subject.hpp"
#include "laws/gateway_subject.hpp"
#include "trama/trama.hpp"

namespace trama {
namespace {

/// Every field that a view gives is the field that decoding gives.
template <class M>
void expect_same(const view<M>& v, const M& m) {
    each_index<M>([&]<std::size_t I>() {
        constexpr auto member = field_of<M, I>.member;
        using wire_type = typename std::remove_cvref_t<decltype(field_of<M, I>)>::wire_type;
        if constexpr (requires { typename wire_type::element; }) {
            for (std::size_t i = 0; i != (m.*member).size(); ++i) {
                const auto one = v.template get<member>(i);
                if constexpr (requires { *one; }) { EXPECT_TRUE(one && *one == (m.*member)[i]) << field_of<M, I>.name; }
                else { expect_same(one, (m.*member)[i]); }
            }
        } else {
            const auto one = v.template get<member>();
            EXPECT_TRUE(one && *one == m.*member) << field_of<M, I>.name;
        }
    });
}

template <class F>
void expect_views() {
    for (std::uint64_t seed = 1; seed != 201; ++seed) {
        test::rng random(seed);
        SCOPED_TRACE(seed);
        const auto units = test::random_units<F>(random, test::manners::wild);
        typename F::decoder decoder;
        std::span<const typename F::unit> in(units);
        const auto e = decoder.next(in);
        if (e.code != errc::ok) continue;  // a daisy packet that a decoder without a past does not trust
        std::size_t seen = 0;
        F::messages::each([&]<class M>() {
            if constexpr (M::layout.fixed) {
                const auto v = view_as<M>(e.packet);
                const auto m = decode<M>(e.packet);
                EXPECT_EQ(v.has_value(), bool(m)) << M::name;
                if (v && m) { expect_same(*v, *m); ++seen; }
            }
        });
        EXPECT_LE(seen, 1U);
    }
}
TEST(view, gives_the_fields_that_decoding_gives) {
    expect_views<daisy::format>();
    expect_views<can::format>();
    expect_views<gateway::format>();
}

TEST(view, of_another_message_is_none) {
    std::array<std::uint8_t, 16> out{};
    const auto size = gateway::encode(gateway::idle_processing{5}, out);
    ASSERT_TRUE(size);
    gateway::decoder decoder;
    std::span<const std::uint8_t> in = std::span(out).first(*size);
    const auto e = decoder.next(in);
    EXPECT_FALSE(view_as<gateway::go_node>(e.packet));
    EXPECT_TRUE(view_as<gateway::idle_processing>(e.packet));
    EXPECT_FALSE(view_as<gateway::idle_processing>(gateway::packet{}));
}

TEST(view, tells_a_malformed_field_and_leaves_the_others_readable) {
    std::array<std::uint8_t, gateway::max_record> out{};
    gateway::cart_state m;
    m.ini_node = 77;
    ASSERT_TRUE(gateway::encode(m, out));
    out[1 + 3 + 5] = 'x';                // cart_id
    out[1 + 206 - 82 + 1] = '-';         // orders[1].type
    gateway::decoder decoder;
    std::span<const std::uint8_t> in(out);
    const auto e = decoder.next(in);
    ASSERT_EQ(e.code, errc::ok);
    const auto v = view_as<gateway::cart_state>(e.packet);
    ASSERT_TRUE(v);
    EXPECT_EQ(v->get<&gateway::cart_state::cart_id>().error(), (error{errc::bad_number, {1}}));
    EXPECT_EQ(v->get<&gateway::cart_state::ini_node>().value_or(0), 77U);
    EXPECT_EQ(v->get<&gateway::cart_state::orders>(0).get<&gateway::transit_order::type>().code(), errc::ok);
    EXPECT_EQ(v->get<&gateway::cart_state::orders>(1).get<&gateway::transit_order::type>().code(), errc::bad_number);
    EXPECT_EQ(decode<gateway::cart_state>(e.packet).error(), (error{errc::bad_number, {1}})) << "decoding names the first";
}

}  // namespace
}  // namespace trama
