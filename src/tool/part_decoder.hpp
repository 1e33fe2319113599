#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "tool/random_file.hpp"
#include "tool/stream_printer.hpp"

namespace trama::tool {

/// Decodes a file from a seam on.
template <class F>
class part_decoder {
public:
    part_decoder(const random_file& file, const options& o, const seam& begin) : file_(file), at_(begin.join), printer_(o, begin) {}

    /// Decodes up to `end`, and again up to a later one. Lines go to `emit`; between two pieces it asks `go_on(place)`.
    void run(seam end, auto&& emit, auto&& go_on) {
        while (at_ < end.place) {
            if (!go_on(at_)) return;
            const auto bytes = file_.read(at_, std::span{bytes_}.first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes_.size(), end.place - at_))));
            printer_.read(bytes, emit);
            at_ += bytes.size();
        }
        sealed_ = end.place == file_.size() || printer_.close_at(end, emit);
        if (end.place == file_.size()) printer_.finish(emit);
    }
    /// What began before the end of the last run is out, and who joins at that seam goes on as this decoder would.
    bool sealed() const { return sealed_; }
    bool at_fault() const { return printer_.at_fault(); }

private:
    const random_file& file_;
    std::uint64_t at_;  ///< Of the next byte to be read.
    bool sealed_ = false;
    stream_printer<F> printer_;
    std::array<std::uint8_t, 1 << 16> bytes_;
};

}  // namespace trama::tool
