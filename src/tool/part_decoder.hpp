#pragma once

#include "tool/event_line.hpp"
#include "tool/seam.hpp"

namespace trama::tool {

/// Decodes a file from a seam on.
template <class F>
class part_decoder {
public:
    part_decoder(const random_file& file, notation style, seam begin) : file_(file), style_(style), begin_(begin), at_(begin.join) { decoder_.seek(at_); }

    /// Decodes up to `end`, and again up to a later one. Lines go to `emit`; between two pieces it asks `go_on(place)`.
    void run(seam end, auto&& emit, auto&& go_on) {
        while (at_ < end.place) {
            if (!go_on(at_)) return;
            const auto bytes = file_.read(at_, std::span{bytes_}.first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes_.size(), end.place - at_))));
            feed(bytes, emit);
            at_ += bytes.size();
        }
        if (end.place == file_.size()) {
            decoder_.finish();
            feed({}, emit);
            sealed_ = true;
        } else if constexpr (is_daisy<F>) {
            sealed_ = decoder_.settled() && decoder_.offset() == end.place;
        } else {
            const std::uint8_t mark = gateway::stx;  // what stands there ends what came before
            feed({&mark, 1}, emit);
            sealed_ = true;
        }
    }
    /// What began before the end of the last run is out, and who joins at that seam goes on as this decoder would.
    bool sealed() const { return sealed_; }
    bool at_fault() const { return at_fault_; }

private:
    void feed(std::span<const std::uint8_t> units, auto& emit) {
        read<F>(decoder_, units, [&](const typename F::event& e) {
            if (e.offset < begin_.place) return;
            text_sink line(line_);
            at_fault_ = print_event<F>(line, e, style_) || at_fault_;
            line << '\n';
            emit(line.view());
        });
    }

    const random_file& file_;
    notation style_;
    seam begin_;
    std::uint64_t at_;  ///< Of the next byte to be read.
    bool at_fault_ = false, sealed_ = false;
    typename F::decoder decoder_;
    std::array<std::uint8_t, 1 << 16> bytes_;
    std::array<char, longest_line> line_;
};

}  // namespace trama::tool
