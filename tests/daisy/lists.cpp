// Lists as messages hold them. Here and not in tests/core, since CI builds this folder with clang.

#include <gtest/gtest.h>

#include "trama/daisy/format.hpp"

namespace trama::daisy {
namespace {

using readings = decltype(distance_sensor::get_value_reply::readings);

std::size_t both(const readings& a, const readings& b) { return a.size() + b.size(); }

// While their constructor was consteval, clang 14 crashed over two lists made in one function where they are used.
TEST(daisy_lists, are_made_where_they_are_used) {
    EXPECT_EQ(both({1}, {2, 3}), 3U);
    EXPECT_EQ(both(readings{1}, readings{2, 3}), 3U);
    EXPECT_NE(readings{1}, readings{2});
}

}  // namespace
}  // namespace trama::daisy
