#include "laws/can_subject.hpp"

namespace trama::test {

template std::vector<can::format::unit> random_units<can::format>(rng&, manners);
template std::string line_of<can::format>(const can::event&);

}  // namespace trama::test
