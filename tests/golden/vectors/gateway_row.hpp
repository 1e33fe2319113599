#pragma once

#include "golden/table.hpp"
#include "trama/trama.hpp"

namespace trama::golden {

/// The fields given as literals, one after the other, between STX and ETX.
template <std::size_t... Size>
consteval auto record(const char (&... fields)[Size]) {
    std::array<std::uint8_t, (2 + ... + (Size - 1))> out{0x02};
    std::size_t at = 1;
    const auto append = [&](const char* s, std::size_t n) { for (std::size_t i = 0; i != n; ++i) out[at++] = static_cast<std::uint8_t>(s[i]); };
    (append(fields, Size - 1), ...);
    out[at] = 0x03;
    return out;
}
/// A row of a gateway table: name, record, message, JSON fields.
template <class M, std::size_t N>
constexpr auto gateway_row(std::string_view name, const std::array<std::uint8_t, N>& wire, const M& m, std::string_view json) {
    return row<gateway::format, M, N>{name, wire, {}, m, json};
}

}  // namespace trama::golden
