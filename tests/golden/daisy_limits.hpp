#pragma once

#include "golden/check.hpp"
#include "golden/limits.hpp"
#include "trama/trama.hpp"

namespace trama::golden {

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
