#pragma once
// The second implementation, tests/reference, as a witness. It is slow, so that it hears the beginning of a stream only.
#include <string>

#include "formats/can.hpp"
#include "formats/daisy.hpp"
#include "formats/gateway.hpp"

namespace trama::bench {

using lines = std::vector<std::string>;

/// What `trama decode` prints for a stream: by the library, and by the reference.
template <class F>
lines library_lines(unit_span<F> in);
template <class F>
lines reference_lines(unit_span<F> in);

/// What a contender must come to in `t` by these lines. Their fields are compared as text: of all but framing the sum is 0.
tally tally_of(const lines& all, task t);
/// Number of lines and a sum that depends on every character.
tally text_of(const lines& all);

}  // namespace trama::bench
