#include "laws/reference.hpp"

#include "laws/daisy_subject.hpp"

namespace trama::test {

INSTANTIATE_TYPED_TEST_SUITE_P(daisy, reference, testing::Types<daisy::format>);

}  // namespace trama::test
