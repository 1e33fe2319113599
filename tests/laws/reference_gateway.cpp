#include "laws/reference.hpp"

#include "laws/gateway_subject.hpp"

namespace trama::test {

INSTANTIATE_TYPED_TEST_SUITE_P(gateway, reference, testing::Types<gateway::format>);

}  // namespace trama::test
