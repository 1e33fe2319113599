#pragma once

#include "trama/gateway/decoder.hpp"

/// Where one large stream may be cut, so that parts decoded by themselves give what the whole gives.
namespace trama::gateway {

inline constexpr std::size_t footing_lead = 0;  ///< Bytes before a cut that must be known: none.

/// The first place from `from` on where a record begins whatever came before it: a STX. `stream.size()` if there is
/// none; 0 for 0. What lies before it is for whoever decodes the bytes before `from`.
constexpr std::size_t footing(std::span<const std::uint8_t> stream, std::size_t from) noexcept {
    if (from == 0) return 0;
    while (from < stream.size() && stream[from] != stx) ++from;
    return std::min(from, stream.size());
}

}  // namespace trama::gateway
