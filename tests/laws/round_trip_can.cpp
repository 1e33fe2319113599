#include "laws/round_trip.hpp"

#include "laws/can_subject.hpp"

namespace trama::test {

INSTANTIATE_TYPED_TEST_SUITE_P(can, round_trip, testing::Types<can::format>);

}  // namespace trama::test
