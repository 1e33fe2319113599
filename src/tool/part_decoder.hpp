#pragma once

#include "tool/event_line.hpp"
#include "tool/seam.hpp"

namespace trama::tool {

/// Prints what a stream of octets says from a seam on.
template <class F>
class stream_printer {
public:
    stream_printer(const options& o, const seam& begin) : style_(o.text ? notation::plain : notation::json), begin_(begin) { decoder_.seek(begin.join); }

    void read(std::span<const std::uint8_t> bytes, auto&& emit) {
        trama::read<F>(decoder_, bytes, [&](const typename F::event& e) {
            if (e.offset < begin_.place) return;
            text_sink line(line_);
            at_fault_ = print_event<F>(line, e, style_) || at_fault_;
            line << '\n';
            emit(line.view());
        });
    }
    void finish(auto&& emit) {
        decoder_.finish();
        read({}, emit);
    }
    /// Whether who joins at the seam `end`, up to which all was read, goes on as this decoder would.
    bool agrees(const seam& end, auto&& emit) {
        if constexpr (is_daisy<F>) return decoder_.settled() && decoder_.offset() == end.place;
        const std::uint8_t mark = gateway::stx;  // what stands there ends what came before
        read({&mark, 1}, emit);
        return true;
    }
    bool at_fault() const { return at_fault_; }

private:
    notation style_;
    seam begin_;
    bool at_fault_ = false;
    typename F::decoder decoder_;
    std::array<char, longest_line> line_;
};

/// The same for a log.
template <>
class stream_printer<can::format> : public log_printer {
public:
    stream_printer(const options& o, const seam& begin) : log_printer(o, begin.lines) {}
    bool agrees(const seam&, auto&&) const { return settled(); }
};

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
        sealed_ = end.place == file_.size() || printer_.agrees(end, emit);
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
