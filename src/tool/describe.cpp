#include "tool/describe.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <unistd.h>

#include "tool/options.hpp"
#include "tool/output.hpp"
#include "trama/core/describe.hpp"
#include "trama/trama.hpp"

namespace trama::tool {

namespace {

using cells = std::vector<std::string>;

/// Writes rows in columns as wide as their widest cell.
void print_table(output& out, const std::vector<cells>& rows) {
    std::vector<std::size_t> widths;
    for (const cells& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i != row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    for (const cells& row : rows) {
        std::string line = "  ";
        for (std::size_t i = 0; i != row.size(); ++i) line += row[i] + std::string(i + 1 == row.size() ? 0 : widths[i] + 2 - row[i].size(), ' ');
        line.erase(line.find_last_not_of(' ') + 1);
        out.write(line + "\n");
    }
}

std::string in_hex(unsigned value) {
    std::array<char, 8> memory;
    text_sink s(memory);
    const std::array<std::uint8_t, 1> byte{static_cast<std::uint8_t>(value)};
    s << "0x";
    s.hex(byte);
    return std::string{s.view()};
}

/// How a message is told from others, and its whole size on the wire.
template <class F, class M>
struct about {
    static constexpr bool is_daisy = std::is_same_v<F, daisy::format>, is_can = std::is_same_v<F, can::format>;
    static constexpr std::size_t first_field = is_daisy ? 4 : is_can ? 0 : 4;

    static std::string kind() {
        if constexpr (is_daisy) return (daisy::command_of(M::key) & daisy::response_bit) != 0 ? "response" : "request";
        else return {};
    }
    static std::string identity() {
        if constexpr (is_daisy) return "command " + in_hex(daisy::command_of(M::key));
        else if constexpr (is_can) return std::string{"letter "} + static_cast<char>(static_cast<unsigned>(M::key) >> 8);
        else return "type " + std::to_string(static_cast<unsigned>(M::key));
    }
    static std::string size() {
        if constexpr (is_can) {
            std::string dlc = "DLC ";
            for (const unsigned n : M::frame_lengths) dlc.append(dlc.size() > 4 ? "+" : "").append(std::to_string(n));
            return dlc;
        } else if constexpr (is_daisy) {
            const std::size_t least = daisy::min_packet + M::layout.size, most = daisy::min_packet + M::layout.max_size;
            return (M::layout.fixed ? std::to_string(least) : std::to_string(least) + ".." + std::to_string(std::min(most, daisy::max_packet))) + " bytes";
        } else {
            return std::to_string(M::layout.size + gateway::type_size + 2) + " bytes";
        }
    }
};

std::string range_of(const layout_row& row) {
    if (row.allowed == nullptr) return {};
    std::array<char, 1024> memory;
    text_sink s(memory);
    s.allowed(*row.allowed);
    return std::string{s.view()};
}

template <class F, class M>
void describe_message(output& out) {
    using facts = about<F, M>;
    out.write(std::string{F::name} + " " + std::string{M::name} + (facts::kind().empty() ? "" : " " + facts::kind()) + ": " + facts::identity() + ", " + facts::size() +
              " [" + std::string{M::section} + "]\n");
    std::vector<cells> rows{{"offset", "size", "name", "type", "range", "meaning"}};
    if constexpr (facts::is_daisy) {
        rows.push_back({"0", "1", "LEN", "u8", "4..255", "bytes that follow"});
        rows.push_back({"1", "1", "DESTINATION", "u8", "", "address of the receiver"});
        rows.push_back({"2", "1", "SOURCE", "u8", "id 0..14", "address of the sender"});
        rows.push_back({"3", "1", "COMMAND", "u8", in_hex(daisy::command_of(M::key)), ""});
    } else if constexpr (!facts::is_can) {
        rows.push_back({"0", "1", "STX", "u8", "0x02", ""});
        rows.push_back({"1", "3", "type", "decimal", std::to_string(static_cast<unsigned>(M::key)), ""});
    }
    bool shifted = false;  // a field of varying size precedes: offsets count from the packet's end
    for_each_row<M>([&](const layout_row& row) {
        const std::string name = row.parent.empty() ? std::string{row.name} : "  ." + std::string{row.name};
        const std::string many = row.count > 1 && row.parent.empty() ? std::string{"["}.append(std::to_string(row.count)).append("]") : std::string{};
        const std::string each = row.count > 1 && !row.parent.empty() ? std::string{" +"}.append(std::to_string(row.stride)).append("i") : std::string{};
        const bool varies = row.size == 0;
        rows.push_back({shifted ? "last" : std::to_string(facts::first_field + row.offset) + each, varies ? "the rest" : std::to_string(row.size) + (many.empty() ? "" : " each"),
                        name + many, std::string{row.type}, range_of(row), std::string{row.meaning}});
        if (row.constant != '\0') rows.push_back({std::to_string(facts::first_field + row.offset + row.size), "1", "letter", "u8", std::string(1, row.constant), ""});
        shifted = shifted || (varies && row.optional);
    });
    if constexpr (facts::is_daisy) rows.push_back({"LEN", "1", "CRC", "u8", "", "exclusive or of all bytes before it"});
    else if constexpr (!facts::is_can) rows.push_back({std::to_string(facts::first_field + M::layout.size), "1", "ETX", "u8", "0x03", ""});
    print_table(out, rows);
}

template <class F>
void list_messages(output& out) {
    std::vector<cells> rows;
    F::messages::each([&]<class M>() { rows.push_back({std::string{M::name}, about<F, M>::kind(), about<F, M>::identity(), about<F, M>::size()}); });
    out.write(std::string{F::name} + "\n");
    print_table(out, rows);
}

template <class F>
int describe_format(output& out, std::span<char*> names) {
    if (names.empty()) {
        list_messages<F>(out);
        return all_well;
    }
    bool found = false;
    F::messages::each([&]<class M>() {
        if (M::name != std::string_view{names[0]}) return;
        if (found) out.write("\n");
        found = true;
        describe_message<F, M>(out);
    });
    if (found) return all_well;
    complain("describe: ", F::name, " has no message ", names[0], "; see trama describe ", F::name);
    return failed;
}

}  // namespace

int describe(std::span<char*> arguments) {
    output out(STDOUT_FILENO);
    if (arguments.size() > 2) {
        complain("describe: too many arguments (see trama --help)");
        return failed;
    }
    int status = all_well;
    if (arguments.empty()) {
        list_messages<daisy::format>(out);
        list_messages<can::format>(out);
        list_messages<gateway::format>(out);
    } else if (const auto p = parse_protocol(arguments[0])) {
        const auto names = arguments.subspan(1);
        status = *p == protocol::daisy ? describe_format<daisy::format>(out, names) : *p == protocol::can ? describe_format<can::format>(out, names) : describe_format<gateway::format>(out, names);
    } else {
        complain("describe: unknown protocol ", arguments[0], " (see trama --help)");
        status = failed;
    }
    out.flush();
    return status;
}

}  // namespace trama::tool
