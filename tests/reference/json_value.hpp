#pragma once

// Reading JSON: a line as a tree of values, and what the encoders ask of such a tree.

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "json_text.hpp"

namespace trama_reference {

/// The line cannot be encoded. Thrown inside the encoders only.
struct refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct json_value {
  enum class kind { null, boolean, number, string, array, object };

  kind type = kind::null;
  std::string number_text = "";         ///< as written
  std::u32string characters = {};       ///< of a string
  std::vector<json_value> items = {};   ///< of an array, or the values of an object's members
  std::vector<std::u32string> names = {};  ///< of an object's members, in the order of their values

  /// The member of that name, or nothing.
  const json_value* find(std::string_view name) const;
};

/// The value that fills the whole line; throws `refused`.
json_value parse_json(std::string_view line);

/// A JSON number without exponent and superfluous zeros: 4.820e1 as "48.2", -0 as "0"; throws `refused`.
std::string plain_number(const json_value& value);

/// A whole number, however it is written, in low..high; throws `refused`.
long long integer(const json_value& value, long long low, long long high);

/// A string's characters, U+0000..U+00FF, as bytes; throws `refused`.
std::string string(const json_value& value);

/// The items of an array that has exactly so many; throws `refused`.
const std::vector<json_value>& array(const json_value& value, std::size_t size);

/// Refuses anything but an object, and any member that is in neither of the lists.
void expect_members(const json_value& object, const std::vector<std::string>& known,
                    const std::vector<std::string>& ignored = {});

/// The common head of a line: an object of this protocol that is no error line. Members beside
/// those of the head and `own` are refused, those that encode ignores are ignored.
json_value parse_line(std::string_view line, std::string_view protocol, std::vector<std::string> own);

}  // namespace trama_reference
