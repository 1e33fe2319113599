#pragma once

// The messages of `can` as tables of bytes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trama_reference {

struct can_form {
  std::string name;
  char letter = ' ';
  std::vector<std::size_t> lengths;  ///< the data bytes of each frame
};

const std::vector<can_form>& can_forms();

/// The form whose first frame has this letter and so many bytes; null if there is none.
const can_form* find_can_form(std::uint8_t letter, std::size_t length);

/// Whether any message has this letter.
bool known_can_letter(std::uint8_t letter);

/// `continuous_all` and the others, with the value of their two letters.
struct can_function {
  std::string name;
  long long value;
};

const std::vector<can_function>& can_functions();

/// Which values a field may have, and how a violation says so.
struct can_range {
  long long low = 0;
  long long high = 0;
  /// `0`, or `low..high`
  std::string text() const;
};

/// The ranges of month, day, hour, minute and second; nothing for a year.
std::optional<can_range> date_range(const std::string& part);

/// The range of `part` (year, month, …) of a start or end under this function.
std::optional<can_range> start_end_range(long long function, const std::string& part);

/// The range of sensor_count under this function.
can_range sensor_count_range(long long function);

}  // namespace trama_reference
