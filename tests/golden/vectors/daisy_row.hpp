#pragma once

#include "golden/table.hpp"
#include "trama/trama.hpp"

namespace trama::golden {

/// A row of a daisy table: name, packet, destination, source, message, JSON fields.
template <class M, std::size_t N>
constexpr auto daisy_row(std::string_view name, const std::array<std::uint8_t, N>& wire, std::uint8_t to, std::uint8_t from, const M& m, std::string_view json) {
    return row<daisy::format, M, N>{name, wire, {{to}, {from}}, m, json};
}

}  // namespace trama::golden
