#include "laws/round_trip.hpp"

#include "laws/gateway_subject.hpp"

namespace trama::test {

INSTANTIATE_TYPED_TEST_SUITE_P(gateway, round_trip, testing::Types<gateway::format>);

}  // namespace trama::test
