// What the golden vectors of the greenhouse masters and nodes prove, and the limits of their fields. [can §1..§5]
#include "golden/check.hpp"
#include "golden/limits.hpp"
#include "golden/vectors/can.hpp"

namespace trama::golden {
namespace {

using namespace can;
using namespace golden::can_messages;

static_assert(messages::count == 7 && covers<messages>(rows));
static_assert(proven<rows>);

constexpr std::string_view functions = "continuous_all|continuous_specific|sleep|interval_all|interval_specific";
constexpr envelope master{0x81};
template <class M>
constexpr auto good(const M& m) { return passes<format>(master, m); }
template <class M, class... More>
constexpr auto bad(const M& m, const More&... expected) { return fails<format>(master, m, expected...); }

constexpr moment first_moment{0, 1, 1, 0, 0, 0}, last_moment{9999, 12, 31, 23, 59, 59};
constexpr define_function interval(moment start, moment end) { return {1, 1, function::interval_all, start, end, 0, {}}; }
constexpr define_function sensors(function f, std::uint8_t count, std::array<std::uint8_t, 4> ids = {}) { return {1, 1, f, {}, {}, count, ids}; }
constexpr define_function timed(function f, std::uint8_t count) { return {1, 1, f, first_moment, first_moment, count, {}}; }

constexpr table limits{
    good(read_sensors{0, 0}), good(read_sensors{255, 200}),
    bad(read_sensors{1, 201}, broken{"message_id", 201, "0..200"}), bad(read_sensors{1, 255}, broken{"message_id", 255, "0..200"}),
    bad(read_actuator{1, 201, 0}, broken{"message_id", 201, "0..200"}), good(read_actuator{255, 200, 255}),
    bad(actuator_state{1, 201, 0, 0}, broken{"message_id", 201, "0..200"}), good(actuator_state{255, 200, 255, 255}),
    bad(set_actuator{1, 201, 0, 0}, broken{"message_id", 201, "0..200"}), good(set_actuator{255, 200, 255, 255}),
    bad(set_clock{1, 201, 0, 1, 1, 0, 0, 0}, broken{"message_id", 201, "0..200"}), good(set_clock{99, 0, 9999, 12, 31, 23, 59, 59}),
    bad(set_clock{1, 0, 0, 0, 0, 24, 60, 60}, broken{"month", 0, "1..12"}, broken{"day", 0, "1..31"}, broken{"hour", 24, "0..23"}, broken{"minute", 60, "0..59"}, broken{"second", 60, "0..59"}),
    bad(set_clock{1, 0, 0, 13, 32, 255, 255, 255}, broken{"month", 13, "1..12"}, broken{"day", 32, "1..31"}, broken{"hour", 255, "0..23"}, broken{"minute", 255, "0..59"}, broken{"second", 255, "0..59"}),
    good(interval(first_moment, last_moment)), good(interval(last_moment, first_moment)),
    bad(interval({0, 0, 0, 24, 60, 60}, first_moment), broken{"start.month", 0, "1..12"}, broken{"start.day", 0, "1..31"}, broken{"start.hour", 24, "0..23"}, broken{"start.minute", 60, "0..59"}, broken{"start.second", 60, "0..59"}),
    bad(interval(first_moment, {0, 13, 32, 24, 60, 60}), broken{"end.month", 13, "1..12"}, broken{"end.day", 32, "1..31"}, broken{"end.hour", 24, "0..23"}, broken{"end.minute", 60, "0..59"}, broken{"end.second", 60, "0..59"}),
    // Without an interval every part of start and end is zero, the year too.
    bad(define_function{1, 1, function::sleep, last_moment, {}, 0, {}}, broken{"start.year", 9999, "0"}, broken{"start.month", 12, "0"}, broken{"start.day", 31, "0"}, broken{"start.hour", 23, "0"}, broken{"start.minute", 59, "0"}, broken{"start.second", 59, "0"}),
    bad(define_function{1, 1, function::continuous_all, {}, {1, 0, 0, 0, 0, 0}, 0, {}}, broken{"end.year", 1, "0"}),
    bad(define_function{1, 1, function::continuous_specific, {0, 13, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 60}, 1, {}}, broken{"start.month", 13, "0"}, broken{"end.second", 60, "0"}),
    // 'X' * 256 + 'Y' = 88*256+89 = 22617; an unnamed function has no interval and any number of sensors.
    bad(sensors(static_cast<function>(22617), 0), broken{"function", 22617, functions}), bad(sensors(static_cast<function>(0), 4), broken{"function", 0, functions}),
    bad(define_function{1, 1, static_cast<function>(0xFFFF), {0, 1, 0, 0, 0, 0}, {}, 5, {}}, broken{"function", 65535, functions}, broken{"start.month", 1, "0"}, broken{"sensor_count", 5, "0..4"}),
    good(sensors(function::continuous_specific, 1, {255})), good(sensors(function::continuous_specific, 4, {1, 2, 3, 4})),
    bad(sensors(function::continuous_specific, 0), broken{"sensor_count", 0, "1..4"}), bad(sensors(function::continuous_specific, 5, {1, 2, 3, 4}), broken{"sensor_count", 5, "1..4"}),
    bad(timed(function::interval_specific, 0), broken{"sensor_count", 0, "1..4"}), good(timed(function::interval_specific, 4)), bad(timed(function::interval_specific, 6), broken{"sensor_count", 6, "1..4"}),
    bad(timed(function::interval_all, 1), broken{"sensor_count", 1, "0"}), bad(sensors(function::continuous_all, 4), broken{"sensor_count", 4, "0"}), bad(sensors(function::sleep, 255), broken{"sensor_count", 255, "0"}),
    bad(sensors(function::continuous_specific, 2, {7, 8, 9, 10}), broken{"sensors[2]", 9, "0"}, broken{"sensors[3]", 10, "0"}),
    bad(sensors(function::sleep, 0, {1, 0, 0, 0}), broken{"sensors[0]", 1, "0"}),
    good(sensor_readings{1, 1, 0, {}}), good(sensor_readings{1, 1, 4, {{{255, 255}, {0, 0}, {1, 1}, {2, 2}}}}),
    bad(sensor_readings{1, 201, 5, {}}, broken{"message_id", 201, "0..200"}, broken{"sensor_count", 5, "0..4"}),
    bad(sensor_readings{1, 1, 3, {{{1, 1}, {2, 2}, {3, 3}, {4, 5}}}}, broken{"readings[3].sensor", 4, "0"}, broken{"readings[3].value", 5, "0"}),
    bad(sensor_readings{1, 1, 0, {{{0, 9}, {}, {8, 0}, {}}}}, broken{"readings[0].value", 9, "0"}, broken{"readings[2].sensor", 8, "0"}),
};
static_assert(limits_proven<limits>);

// A year has two bytes of two digits.
static_assert(unwritable<format>(master, set_clock{1, 1, 10000, 1, 1, 0, 0, 0}, {2}));
static_assert(unwritable<format>(master, interval({10000, 1, 1, 0, 0, 0}, first_moment), {3, field_ref::none, 0}));
static_assert(unwritable<format>(master, interval(first_moment, {65535, 1, 1, 0, 0, 0}), {4, field_ref::none, 0}));

/// Frames with one byte, DLC, identifier or kind changed.
constexpr auto every_frame_fault = [](const auto& wire, auto&& f) {
    for (std::size_t at = 0; at != wire.size(); ++at) {
        auto damaged = wire;
        const auto give = [&](unsigned how) {
            f(damaged, at, how);
            damaged = wire;
        };
        for (std::size_t i = 0; i != wire[at].length; ++i)
            for (unsigned by = 1; by != 256; ++by) {
                damaged[at].data[i] = static_cast<std::uint8_t>(damaged[at].data[i] ^ by);
                give(static_cast<unsigned>(i) << 8 | by);
            }
        for (std::uint8_t length = 0; length <= 8; ++length) {
            damaged[at].length = length;
            if (length != wire[at].length) give(0x1000U + length);
            damaged = wire;
        }
        for (std::uint32_t bit = 0; bit != 11; ++bit) {
            damaged[at].id ^= 1U << bit;
            give(0x2000U + bit);
        }
        damaged[at].extended = true;
        give(0x3000);
        damaged[at].remote = true;
        give(0x3001);
        damaged[at].error = true;
        give(0x3002);
        damaged[at].fd = true;
        give(0x3003);
    }
};

TEST(can, rows_hold) { check_rows(rows); }
TEST(can, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(can, one_fault_in_a_frame_never_passes) { check_damage(rows, every_frame_fault, never_same); }
TEST(can, limits) { check_limits(limits); }
TEST(can, years_beyond_two_digits_a_byte) {
    EXPECT_TRUE(unwritable<format>(master, set_clock{1, 1, 10000, 1, 1, 0, 0, 0}, {2}));
    using frames = std::vector<frame>;
    EXPECT_EQ((bad_number_path<format, set_clock>(frames{data(0x80, 10, 9, 'C', 100, 11, 4, 1, 12), data(0x80, 20, 30)})), "year");
    EXPECT_EQ((bad_number_path<format, set_clock>(frames{data(0x80, 10, 9, 'C', 20, 100, 4, 1, 12), data(0x80, 20, 30)})), "year");
    EXPECT_EQ((bad_number_path<format, set_clock>(frames{data(0x80, 10, 9, 'C', 99, 99, 4, 1, 12), data(0x80, 20, 30)})), "decodes");
    const auto interval_frames = [](int start_century, int end_year) {
        return frames{data(0x80, 10, 3, 'F', 'I', 'S', start_century, 11, 3), data(0x80, 13, 20, end_year, 3, 15, 9, 15, 10), data(0x80, 23, 30, 5, 4, 0, 1, 2, 3)};
    };
    EXPECT_EQ((bad_number_path<format, define_function>(interval_frames(100, 11))), "start.year");
    EXPECT_EQ((bad_number_path<format, define_function>(interval_frames(20, 255))), "end.year");
    EXPECT_EQ((bad_number_path<format, define_function>(interval_frames(255, 255))), "start.year");
    EXPECT_EQ((bad_number_path<format, define_function>(interval_frames(99, 99))), "decodes");
}

}  // namespace
}  // namespace trama::golden
