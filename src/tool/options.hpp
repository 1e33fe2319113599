#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "tool/candump.hpp"

namespace trama::tool {

enum class protocol : std::uint8_t { daisy, can, gateway };

/// The command line of decode and encode.
struct options {
    tool::protocol protocol{};
    std::string_view file = "-";  ///< `-`: standard input.
    bool hex = false;
    bool text = false;
    bool unchecked = false;
    std::uint64_t timeout = per_second;
    unsigned jobs = 1;                ///< Cores to decode on.
    bool ranged = false;              ///< Only what begins in `from`..`to`, in bytes.
    std::uint64_t from = 0, to = 0;
};

std::optional<protocol> parse_protocol(std::string_view name) noexcept;

/// Reads the arguments behind `decode` or `encode`; complains and gives nothing when they are wrong.
std::optional<options> parse_options(std::string_view command, std::span<char*> arguments);

}  // namespace trama::tool
