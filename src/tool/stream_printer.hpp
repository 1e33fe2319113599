#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "tool/event_line.hpp"
#include "tool/log_decoder.hpp"
#include "tool/options.hpp"
#include "tool/seam.hpp"

namespace trama::tool {

/// Makes lines of what a decoder reports, as the options ask for, and keeps whether any of it was at fault.
class line_maker {
public:
    explicit line_maker(const options& o) : style_(o.text ? notation::plain : notation::json) {}

    template <class F>
    void event(const typename F::event& e, auto& emit) {
        text_sink line(line_);
        at_fault_ = print_event<F>(line, e, style_) || at_fault_;
        line << '\n';
        emit(line.view());
    }
    void bad_line(std::uint64_t number, auto& emit) {
        text_sink line(line_);
        print_bad_line(line, number, style_);
        line << '\n';
        at_fault_ = true;
        emit(line.view());
    }
    bool at_fault() const noexcept { return at_fault_; }

private:
    notation style_;
    bool at_fault_ = false;
    std::array<char, longest_line> line_;
};

/// Prints what a stream of octets says from a seam on.
template <class F>
class stream_printer {
    static_assert(is_daisy<F> || is_gateway<F>, "each format has its own rule at a seam");

public:
    explicit stream_printer(const options& o, const seam& begin = {}) : lines_(o), begin_(begin.place) { decoder_.seek(begin.join); }

    void read(std::span<const std::uint8_t> bytes, auto&& emit) {
        trama::read<F>(decoder_, bytes, [&](const typename F::event& e) {
            if (e.offset >= begin_) lines_.event<F>(e, emit);
        });
    }
    void finish(auto&& emit) {
        decoder_.finish();
        read({}, emit);
    }
    /// All was read up to the seam `end`: prints what it ends. Whether who joins there goes on as this decoder would.
    bool close_at(const seam& end, auto&& emit) {
        if constexpr (is_daisy<F>) return decoder_.settled() && decoder_.offset() == end.place;
        const std::uint8_t mark = gateway::stx;  // what stands there ends what came before
        read({&mark, 1}, emit);
        return true;
    }
    bool at_fault() const noexcept { return lines_.at_fault(); }

private:
    line_maker lines_;
    std::uint64_t begin_;
    typename F::decoder decoder_;
};

/// Prints what a log says.
template <>
class stream_printer<can::format> {
public:
    explicit stream_printer(const options& o, const seam& begin = {}) : lines_(o), decoder_(o.timeout, begin.lines) {}

    void read(std::span<const std::uint8_t> bytes, auto&& emit) {
        decoder_.read(bytes, [&](const can::event& e) { lines_.event<can::format>(e, emit); }, [&](std::uint64_t number) { lines_.bad_line(number, emit); });
    }
    void finish(auto&& emit) {
        decoder_.finish([&](const can::event& e) { lines_.event<can::format>(e, emit); }, [&](std::uint64_t number) { lines_.bad_line(number, emit); });
    }
    bool close_at(const seam&, auto&&) const noexcept { return decoder_.settled(); }
    bool at_fault() const noexcept { return lines_.at_fault(); }

private:
    line_maker lines_;
    log_decoder decoder_;
};

}  // namespace trama::tool
