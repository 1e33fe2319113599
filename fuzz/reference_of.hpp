#pragma once
// Where the second implementation of each format plugs into the targets `differential` and `text`.
#include <optional>
#include <string>

#include "formats/can.hpp"
#include "formats/daisy.hpp"
#include "formats/gateway.hpp"
#include "reference/reference.hpp"

namespace trama::fuzz {

using text_lines = std::vector<std::string>;

/// What the reference says in the command line's terms: `lines` of a stream with silences at the places given, and
/// `encode` of a line, nothing where it is refused. A format without a reference has none of these targets.
template <wire_format F>
struct reference_of;

template <>
struct reference_of<daisy::format> {
    static text_lines lines(std::span<const std::uint8_t> stream, std::span<const std::size_t> idle_at) {
        return trama_reference::daisy_lines(stream, idle_at);
    }
    static std::optional<octets> encode(std::string_view line, bool unchecked) { return trama_reference::daisy_encode(line, unchecked); }
};

template <>
struct reference_of<gateway::format> {
    static text_lines lines(std::span<const std::uint8_t> stream, std::span<const std::size_t>) { return trama_reference::gateway_lines(stream); }
    static std::optional<octets> encode(std::string_view line, bool unchecked) { return trama_reference::gateway_encode(line, unchecked); }
};

/// Its streams are logs with times; `timeout` in seconds.
template <>
struct reference_of<can::format> {
    static text_lines lines(std::string_view log, double timeout) { return trama_reference::can_lines(log, timeout); }
    static std::optional<octets> encode(std::string_view line, bool unchecked) {
        const auto log = trama_reference::can_encode(line, unchecked);
        if (!log) return std::nullopt;
        return octets(log->begin(), log->end());
    }
};

}  // namespace trama::fuzz
