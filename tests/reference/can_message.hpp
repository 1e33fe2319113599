#pragma once

// The typed meaning of a reassembled `can` message.

#include <string>

#include "can_table.hpp"
#include "json_text.hpp"

namespace trama_reference {

struct can_meaning {
  std::string bad_number;  ///< the field that is no number; empty: all well
  std::string fields;      ///< the JSON object
  std::vector<violation> violations;
};

/// `data`: the frames' data run together.
can_meaning read_can_message(const can_form& form, const octets& data);

}  // namespace trama_reference
