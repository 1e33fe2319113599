#pragma once

#include "trama/daisy/decoder.hpp"

/// Where one large stream may be cut, so that parts decoded by themselves give what the whole gives.
namespace trama::daisy {

inline constexpr std::size_t footing_lead = 1024;   ///< Bytes before a cut from which a decoder finds its footing.
inline constexpr std::size_t footing_clean = 512;   ///< Bytes without a fault that it takes to be sure.

/// The first place from `from` on where a decoder that joins the stream `footing_lead` bytes before `from` is settled and
/// has seen `footing_clean` bytes without a fault. `stream.size()` if there is no such place; 0 for 0.
///
/// The stream may be cut there if the decoder of what lies before agrees: fed all of it, its `offset()` is this place and
/// it is `settled()`. From there on both report the same. Else that decoder has to go on, to a later footing: some
/// streams can be read in two ways, and only their beginning tells which it is.
constexpr std::size_t footing(std::span<const std::uint8_t> stream, std::size_t from) noexcept {
    if (from == 0) return 0;
    const std::size_t start = from - std::min(from, footing_lead);
    decoder joining;
    joining.seek(start);
    auto in = stream.subspan(std::min(start, stream.size()));
    for (std::uint64_t clean_from = start;;) {
        auto e = joining.next(in);
        if (e.code == errc::need_more) return stream.size();
        const std::uint64_t end = e.offset + e.length;
        if (e.code != errc::ok && e.code != errc::unknown_message) clean_from = end;
        if (end >= from && joining.settled() && end - clean_from >= footing_clean) return static_cast<std::size_t>(end);
    }
}

}  // namespace trama::daisy
