#include "trama/gateway/flags.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "trama/gateway/format.hpp"

namespace trama::gateway {
namespace {

constexpr cart_status unnamed{0x1000};  ///< The lowest bit without a name.

TEST(gateway_flags, combine_as_sets) {
    using enum cart_status;
    static_assert((busy | ready) == static_cast<cart_status>(0xC0));
    static_assert((busy | ready) == (ready | busy) && ((busy | ready) & ready) == ready);
    static_assert(((busy | ready) ^ (ready | parking)) == (busy | parking));
    static_assert((circuit_check::cart_lost ^ circuit_check::cart_lost) == circuit_check::ok);
    EXPECT_TRUE(any_of(busy | ready, ready | parking));
    EXPECT_FALSE(any_of(busy | ready, parking));
}

TEST(gateway_flags, are_set_cleared_and_toggled_in_place) {
    cart_status status = cart_status::none;
    EXPECT_EQ(&(status |= cart_status::busy), &status);
    status |= cart_status::ready;
    EXPECT_EQ(status, cart_status::busy | cart_status::ready);
    status &= ~cart_status::busy;
    EXPECT_EQ(status, cart_status::ready);
    status ^= cart_status::ready | cart_status::loaded;
    EXPECT_EQ(status, cart_status::loaded);
}

TEST(gateway_flags, clearing_one_keeps_those_without_a_name) {
    static_assert(name_of(unnamed).empty());
    cart_status status = unnamed | cart_status::busy | cart_status::ready;
    status &= ~cart_status::busy;
    EXPECT_EQ(status, unnamed | cart_status::ready);
    static_assert((~cart_status::busy & cart_status::busy) == cart_status::none);
    static_assert(~~cart_status::busy == cart_status::busy && ~~circuit_check::ok == circuit_check::ok);
}

TEST(gateway_flags, the_complement_has_the_bits_that_the_columns_can_hold_and_no_others) {
    messages::each([]<class M>() {
        each_index<M>([]<std::size_t I>() {
            using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
            using value = typename one::value;
            if constexpr (flag_set<value>) {
                constexpr auto carried = std::bit_ceil(static_cast<std::uint64_t>(one::wire_type::high)) - 1;
                EXPECT_EQ(static_cast<std::uint64_t>(~value{}), carried) << field_of<M, I>.name;
                for (const auto& e : names(value{})) EXPECT_EQ(~value{} & e.value, e.value) << e.name;
            }
        });
    });
}

}  // namespace
}  // namespace trama::gateway
