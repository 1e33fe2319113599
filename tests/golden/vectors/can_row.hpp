#pragma once

#include "golden/table.hpp"
#include "trama/trama.hpp"

namespace trama::golden {

template <class... Byte>
constexpr can::frame data(std::uint32_t id, Byte... bytes) {
    static_assert(sizeof...(Byte) <= 8);
    return can::frame{.id = id, .length = sizeof...(Byte), .data = {static_cast<std::uint8_t>(bytes)...}};
}
/// A row of a can table: name, message, JSON fields, frames.
template <class M, class... Frame>
constexpr auto can_row(std::string_view name, const M& m, std::string_view json, const Frame&... frames) {
    const std::array<can::frame, sizeof...(Frame)> all{frames...};
    return row<can::format, M, sizeof...(Frame)>{name, all, {all[0].id}, m, json};
}

}  // namespace trama::golden
