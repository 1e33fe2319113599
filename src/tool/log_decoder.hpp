#pragma once

#include "tool/candump.hpp"
#include "tool/event_line.hpp"
#include "tool/lines.hpp"
#include "tool/options.hpp"

namespace trama::tool {

/// Decodes a candump log as it comes, timed and numbered by its lines.
class log_decoder {
public:
    /// `lines` of the log lie before what it will read.
    explicit log_decoder(std::uint64_t timeout, std::uint64_t lines = 0)
        : lines_(lines), reassembler_({can::central_master, can::master_1, can::master_2}, timeout) {}

    /// Calls `on_event(event)`, and `on_bad_line(number)` for lines that are none of candump's.
    void read(std::span<const unsigned char> bytes, auto&& on_event, auto&& on_bad_line) {
        lines_.read(bytes, [&](std::string_view line, bool too_long) { take(line, too_long, on_event, on_bad_line); });
    }
    void finish(auto&& on_event, auto&& on_bad_line) {
        lines_.finish([&](std::string_view line, bool too_long) { take(line, too_long, on_event, on_bad_line); });
        reassembler_.finish();
        trama::read<can::format>(reassembler_, {}, on_event);
    }
    /// Nothing is kept: a decoder that begins here goes on alike.
    bool settled() const noexcept { return reassembler_.pending() == 0; }

private:
    void take(std::string_view line, bool too_long, auto& on_event, auto& on_bad_line) {
        const auto frame = too_long ? std::nullopt : parse_candump(line);
        if (!frame) return on_bad_line(lines_.number());
        reassembler_.tick(frame->time);
        reassembler_.seek(lines_.number());
        trama::read<can::format>(reassembler_, {&*frame, 1}, on_event);
    }

    line_reader lines_;
    can::reassembler reassembler_;
};

/// Prints what a log says.
class log_printer {
public:
    explicit log_printer(const options& o, std::uint64_t lines = 0) : decoder_(o.timeout, lines), style_(o.text ? notation::plain : notation::json) {}

    void read(std::span<const unsigned char> bytes, auto&& emit) {
        decoder_.read(bytes, [&](const can::event& e) { print(e, emit); }, [&](std::uint64_t number) { note(number, emit); });
    }
    void finish(auto&& emit) {
        decoder_.finish([&](const can::event& e) { print(e, emit); }, [&](std::uint64_t number) { note(number, emit); });
    }
    bool settled() const noexcept { return decoder_.settled(); }
    bool at_fault() const noexcept { return at_fault_; }

private:
    void print(const can::event& e, auto& emit) {
        text_sink line(line_);
        at_fault_ = print_event<can::format>(line, e, style_) || at_fault_;
        line << '\n';
        emit(line.view());
    }
    void note(std::uint64_t number, auto& emit) {
        text_sink line(line_);
        if (style_ == notation::json) line << "{\"protocol\":\"can\",\"line\":" << number << ",\"error\":\"bad_line\"}\n";
        else line << "protocol=can line=" << number << " error=bad_line\n";
        at_fault_ = true;
        emit(line.view());
    }

    log_decoder decoder_;
    notation style_;
    bool at_fault_ = false;
    std::array<char, longest_line> line_;
};

}  // namespace trama::tool
