#include "laws/gateway_subject.hpp"

namespace trama::test {

template std::vector<gateway::format::unit> random_units<gateway::format>(rng&, manners);
template std::string line_of<gateway::format>(const gateway::event&);

}  // namespace trama::test
