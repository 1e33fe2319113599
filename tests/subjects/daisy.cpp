#include "laws/daisy_subject.hpp"

namespace trama::test {

template std::vector<daisy::format::unit> random_units<daisy::format>(rng&, manners);
template std::string line_of<daisy::format>(const daisy::event&);

}  // namespace trama::test
