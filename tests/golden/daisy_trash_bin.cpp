// What the golden vectors of the trash bin boards prove, and the limits of their fields. [daisy §10]
#include "golden/daisy_limits.hpp"
#include "golden/vectors/daisy_trash_bin.hpp"

namespace trama::golden {
namespace {

using namespace daisy::trash_bin;
using namespace golden::daisy_trash_bin;

static_assert(covers<daisy::trash_bin::messages>(rows));
static_assert(proven<rows>);

constexpr table limits{
    allowed(get_trash_bin_value_reply{0}), allowed(get_trash_bin_value_reply{0x3FF}),
    refused(get_trash_bin_value_reply{0x400}, broken{"value", 1024, "0..1023"}), refused(get_trash_bin_value_reply{0xFFFF}, broken{"value", 65535, "0..1023"}),
    allowed(set_full_bin_value{0}), allowed(set_full_bin_value{0x3FF}),
    refused(set_full_bin_value{0x400}, broken{"value", 1024, "0..1023"}), refused(set_full_bin_value{0xFFFF}, broken{"value", 65535, "0..1023"}),
};
static_assert(limits_proven<limits>);

TEST(daisy_trash_bin, rows_hold) { check_rows(rows); }
TEST(daisy_trash_bin, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(daisy_trash_bin, one_damaged_byte_never_passes) { check_damage(rows, every_byte, never_same); }
TEST(daisy_trash_bin, limits) { check_limits(limits); }

}  // namespace
}  // namespace trama::golden
