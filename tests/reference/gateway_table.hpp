#pragma once

// The records of `gateway` as tables: which fields a payload holds, and what they may hold.

#include <cstddef>
#include <string>
#include <vector>

namespace trama_reference {

enum class content {
  number,         ///< unsigned decimal
  signed_number,  ///< [D16]
  tenths,         ///< `d`: xxx.x
  text,           ///< `t`
  named,          ///< a number with names, an open enumeration
  order_type,     ///< the same, with the messages' names
  bits            ///< a number read as a set of named bits
};

struct gateway_field {
  std::string name;
  std::size_t width = 0;
  content kind = content::number;
  long long low = 0;
  long long high = -1;  ///< below low: no range
  std::vector<std::string> names = {};  ///< of values 0, 1, 2, … or of bits, lowest first
  std::vector<int> allowed_types = {};  ///< of an order type
};

struct gateway_message {
  int type = 0;
  std::string name;
  std::vector<gateway_field> fields;  ///< behind `type`, without the orders
  std::size_t orders = 0;             ///< transit orders behind the fields

  std::size_t payload() const;
};

const std::vector<gateway_message>& gateway_messages();
const std::vector<gateway_field>& transit_order_fields();

/// The name of an order type, 0 being `none`; empty if it has none.
std::string order_type_name(long long type);

/// The names of these order types with `|` between them.
std::string order_type_names(const std::vector<int>& types);

}  // namespace trama_reference
