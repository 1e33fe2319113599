#include "trama/can/format.hpp"

#include <gtest/gtest.h>

namespace trama::can {
namespace {

TEST(can_format, the_free_encoders_are_those_of_the_format) {
    const set_actuator good{1, 200, 0, 0}, bad{1, 201, 0, 0};
    std::array<frame, max_frames> free{}, own{};
    EXPECT_EQ(encode({master_1}, bad, free).error(), (error{errc::out_of_range, {1}}));
    EXPECT_EQ(free, own) << "a refused message writes nothing";
    EXPECT_EQ(encode_unchecked({master_1}, bad, free), format::encode_unchecked({master_1}, bad, own));
    EXPECT_EQ(free, own);
    EXPECT_EQ(free[0], (frame{master_1, 5, {1, 201, 'M', 0, 0}}));
    EXPECT_EQ(encode({master_1}, good, free).value_or(0), 1U);
    EXPECT_EQ(encode_unchecked({master_1}, good, own).value_or(0), 1U);
    EXPECT_EQ(free, own);
    EXPECT_EQ(encode_unchecked({master_1}, good, std::span<frame>()).code(), errc::buffer_too_small);
}

}  // namespace
}  // namespace trama::can
