#pragma once

// The messages of `daisy` as tables: what each packet may hold.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trama_reference {

enum class family { common, dc_motor, servo_motor, distance_sensor, battery_controller, trash_bin, none };

/// A little-endian integer in DATA, or `count` of them in a row under one name.
struct number_field {
  std::string name;
  std::size_t size = 1;
  bool is_signed = false;
  long long low = 0;
  long long high = 0;
  std::vector<std::string> names = {};  ///< named values 0, 1, 2, …
  std::size_t count = 1;                ///< more than 1: an array
};

enum class shape {
  fixed,     ///< the fields, one after another
  text,      ///< a description
  readings,  ///< a mask and one u16 for each bit set in it
  error      ///< a code, and for code 0 the rejected packet and the expected CRC
};

struct message_form {
  family owner = family::common;
  std::string name;
  std::uint8_t command = 0;  ///< bit 7 included
  shape form = shape::fixed;
  std::vector<number_field> fields = {};
};

/// "dc_motor"
std::string family_name(family owner);

/// [D3] The message that this command means between these addresses; null if there is none.
/// Whether the groups themselves are documented is not looked at.
const message_form* find_message(std::uint8_t destination, std::uint8_t source, std::uint8_t command);

/// The message printed as "dc_motor.set_direction"; null if there is none.
const message_form* find_message(std::string_view printed_name, bool response);

/// Groups 0…6 on both ends, or destination 0xFF for a common command.
bool documented_addresses(std::uint8_t destination, std::uint8_t source, std::uint8_t command);

/// Whether the message can have this LEN, as far as the first DATA byte (if known) tells.
bool length_possible(const message_form& message, std::uint8_t len, std::optional<std::uint8_t> first_data);

/// `sensors`, the mask that heads `readings` and stands alone in other messages.
number_field sensor_mask();

}  // namespace trama_reference
