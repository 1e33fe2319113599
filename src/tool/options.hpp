#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "tool/candump.hpp"

namespace trama::tool {

enum class protocol : std::uint8_t { daisy, can, gateway };

/// The command line behind a command.
struct options {
    enum class wish : std::uint8_t { command, help, version };
    wish asked = wish::command;       ///< If it is not the command, nothing else counts.
    unsigned operands = 0;            ///< How many of the protocol and of the file or message are there.
    tool::protocol protocol{};
    std::string_view file = "-";      ///< `-`: standard input.
    std::string_view message{};       ///< Of describe.
    bool hex = false;
    bool text = false;
    bool unchecked = false;
    std::uint64_t timeout = per_second;
    unsigned jobs = 1;                ///< Cores to decode on.
    bool ranged = false;              ///< Only what begins in `from`..`to`, in bytes.
    std::uint64_t from = 0, to = 0;
};

std::optional<protocol> parse_protocol(std::string_view name) noexcept;

/// What a word asks for: help, the version, or neither.
options::wish parse_wish(std::string_view word) noexcept;

/// Reads the arguments behind `decode`, `encode` or `describe`; complains and gives nothing when they are wrong.
std::optional<options> parse_options(std::string_view command, std::span<char*> arguments);

}  // namespace trama::tool
