#include "laws/reference.hpp"

#include "laws/can_subject.hpp"

namespace trama::test {

INSTANTIATE_TYPED_TEST_SUITE_P(can, reference, testing::Types<can::format>);

}  // namespace trama::test
