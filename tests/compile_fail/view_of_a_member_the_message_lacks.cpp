// expect: no matching (member )?function
#include "trama/core/view.hpp"
#include "trama/gateway/format.hpp"

using trama::gateway::cart_state;
using trama::gateway::circuit_state;

void use(trama::view<cart_state> view) {
    (void)view.get<&cart_state::speed_mms>();
    (void)view.get<&circuit_state::mode>();  // wrong
}
