#pragma once

#include "tool/candump.hpp"
#include "tool/lines.hpp"
#include "trama/can/format.hpp"

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

}  // namespace trama::tool
