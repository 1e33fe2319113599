#pragma once

#include "golden/check.hpp"
#include "golden/limits.hpp"
#include "trama/trama.hpp"

namespace trama::golden {

/// A row of a daisy table: name, packet, destination, source, message, JSON fields.
template <class M, std::size_t N>
constexpr auto daisy_row(std::string_view name, const std::array<std::uint8_t, N>& wire, std::uint8_t to, std::uint8_t from, const M& m, std::string_view json) {
    return row<daisy::format, M, N>{name, wire, {{to}, {from}}, m, json};
}

/// Main controller 0:0 and board 1 of the family that defines `M`; commands that all boards have go to a motor.
template <class M>
inline constexpr daisy::envelope usual_addresses = [] {
    const daisy::family f = daisy::family_of(M::key);
    const daisy::address one = daisy::board(f == daisy::family::common ? 1 : static_cast<unsigned>(f), 1);
    const bool response = (daisy::command_of(M::key) & 0x80) != 0;
    return response ? daisy::envelope{daisy::board(0, 0), one} : daisy::envelope{one, daisy::board(0, 0)};
}();

template <class M>
constexpr auto allowed(const M& m) {
    return passes<daisy::format>(usual_addresses<M>, m);
}
template <class M, class... More>
constexpr auto refused(const M& m, const More&... expected) {
    return fails<daisy::format>(usual_addresses<M>, m, expected...);
}

}  // namespace trama::golden
