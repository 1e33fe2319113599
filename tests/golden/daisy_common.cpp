// What the golden vectors of the commands that every board has prove, and the limits of their fields. [daisy §3]
#include "golden/daisy_limits.hpp"
#include "golden/vectors/daisy_common.hpp"

namespace trama::golden {
namespace {

using namespace daisy::common;
using daisy::common::error;
using namespace golden::daisy_common;

static_assert(covers<daisy::common::messages>(rows));
static_assert(daisy::messages::count == 93);
static_assert(proven<rows>);

constexpr table limits{
    allowed(init_reply{}), allowed(init_reply{first(1)}), allowed(init_reply{first(251)}),
    allowed(reset_reply{}), allowed(reset_reply{first(251)}),
    allowed(error{1}), allowed(error{255}),
    allowed(error{0, first(5), 0}), allowed(error{0, first(5), 255}), allowed(error{0, first(249), 0}),
};
static_assert(limits_proven<limits>);

TEST(daisy_common, rows_hold) { check_rows(rows); }
TEST(daisy_common, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(daisy_common, one_damaged_byte_never_passes) { check_damage(rows, every_byte, never_same); }
TEST(daisy_common, limits) { check_limits(limits); }

// Lists that the wire cannot carry: no encoder writes them.
template <class M>
constexpr bool no_room(const M& m, std::uint8_t field) { return unwritable<daisy::format>(usual_addresses<M>, m, {field}); }
static_assert(no_room(init_reply{first(252)}, 0));
static_assert(no_room(reset_reply{first(252)}, 0));
static_assert(no_room(error{0, first(4), 0}, 1));
static_assert(no_room(error{0, first(250), 0}, 1));

TEST(daisy_common, too_long_or_too_short_to_write) {
    EXPECT_TRUE(no_room(init_reply{first(252)}, 0));
    EXPECT_TRUE(no_room(reset_reply{first(252)}, 0));
    EXPECT_TRUE(no_room(error{0, first(4), 0}, 1));
    EXPECT_TRUE(no_room(error{0, first(250), 0}, 1));
    EXPECT_TRUE(no_room(error{}, 1));
}

// Codes other than 0 carry one byte: a rejected packet beside them is refused, and not written unchecked.
constexpr bool one_byte_only() {
    const error stray{1, first(5), 9};
    properties::page<daisy::format> out;
    if (daisy::format::encode(usual_addresses<error>, stray, out.all).error() != trama::error{errc::out_of_range, {1}} || !out.untouched_from(0)) return false;
    const auto size = daisy::format::encode_unchecked(usual_addresses<error>, stray, out.all);
    constexpr auto wire = octets("05 11 00 04 01 11");
    return size && *size == wire.size() && std::equal(wire.begin(), wire.end(), out.all.begin());
}
static_assert(one_byte_only());
TEST(daisy_common, codes_other_than_0_carry_one_byte) { EXPECT_TRUE(one_byte_only()); }

}  // namespace
}  // namespace trama::golden
