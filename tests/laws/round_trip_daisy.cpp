#include "laws/round_trip.hpp"

#include "laws/daisy_subject.hpp"

namespace trama::test {

INSTANTIATE_TYPED_TEST_SUITE_P(daisy, round_trip, testing::Types<daisy::format>);

}  // namespace trama::test
