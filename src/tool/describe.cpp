#include "tool/describe.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <unistd.h>

#include "tool/output.hpp"
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

/// What the schema tells about one message, without its type, so that the rest need not be compiled for each.
struct portrait {
    tool::protocol protocol{};
    std::string_view format, name, section;
    unsigned identity = 0;                     ///< Command, letter or type.
    std::span<const std::uint8_t> frames;      ///< Lengths of a can message's frames.
    std::size_t size = 0, max_size = 0;        ///< Of the fields.
    std::vector<layout_row> fields;

    bool response() const { return protocol == protocol::daisy && (identity & daisy::response_bit) != 0; }
    std::size_t first_field() const { return protocol == protocol::can ? 0 : 4; }
};

template <class F, class M>
portrait draw() {
    portrait p;
    p.format = F::name;
    p.protocol = *parse_protocol(F::name);
    p.name = M::name;
    p.section = M::section;
    p.size = M::layout.size;
    p.max_size = M::layout.max_size;
    if constexpr (std::is_same_v<F, daisy::format>) p.identity = daisy::command_of(M::key);
    else if constexpr (std::is_same_v<F, can::format>) p.identity = static_cast<unsigned>(M::key) >> 8;
    else p.identity = static_cast<unsigned>(M::key);
    if constexpr (requires { M::frame_lengths; }) p.frames = M::frame_lengths;
    for_each_row<M>([&](const layout_row& row) { p.fields.push_back(row); });
    return p;
}

std::string kind(const portrait& p) {
    if (p.protocol != protocol::daisy) return {};
    return p.response() ? "response" : "request";
}

std::string identity(const portrait& p) {
    if (p.protocol == protocol::daisy) return "command " + in_hex(p.identity);
    if (p.protocol == protocol::can) return std::string{"letter "} + static_cast<char>(p.identity);
    return "type " + std::to_string(p.identity);
}

std::string size(const portrait& p) {
    if (p.protocol == protocol::can) {
        std::string dlc = "DLC ";
        for (const unsigned n : p.frames) dlc.append(dlc.size() > 4 ? "+" : "").append(std::to_string(n));
        return dlc;
    }
    const std::size_t around = p.protocol == protocol::daisy ? daisy::min_packet : gateway::type_size + 2;
    std::string text = std::to_string(around + p.size);
    if (p.max_size != p.size) text.append("..").append(std::to_string(std::min(around + p.max_size, daisy::max_packet)));
    return text + " bytes";
}

std::string range_of(const layout_row& row) {
    if (row.allowed == nullptr) return {};
    std::array<char, 1024> memory;
    text_sink s(memory);
    s.allowed(*row.allowed);
    return std::string{s.view()};
}

/// The bits of a flag set, which are too many for a column.
void print_flags(output& out, const layout_row& row) {
    if (row.flags.empty()) return;
    std::string line{"  bits of "};
    line.append(row.name).append(", lowest first:");
    for (const std::string_view name : row.flags) line.append(" ").append(name);
    out.write(line + "\n");
}

void print_portrait(output& out, const portrait& p) {
    std::string title{p.format};
    title.append(" ").append(p.name).append(kind(p).empty() ? "" : " ").append(kind(p)).append(": ");
    out.write(title.append(identity(p)).append(", ").append(size(p)).append(" [").append(p.section).append("]\n"));
    std::vector<cells> rows{{"offset", "size", "name", "type", "range", "meaning"}};
    if (p.protocol == protocol::daisy) {
        rows.push_back({"0", "1", "LEN", "u8", "4..255", "bytes that follow"});
        rows.push_back({"1", "1", "DESTINATION", "u8", "", "address of the receiver"});
        rows.push_back({"2", "1", "SOURCE", "u8", "id 0..14", "address of the sender"});
        rows.push_back({"3", "1", "COMMAND", "u8", in_hex(p.identity), ""});
    } else if (p.protocol == protocol::gateway) {
        rows.push_back({"0", "1", "STX", "u8", "0x02", ""});
        rows.push_back({"1", "3", "type", "decimal", std::to_string(p.identity), ""});
    }
    for (const layout_row& row : p.fields) {
        const bool inner = !row.parent.empty(), many = row.count > 1, varies = row.size == 0;
        std::string offset = row.from_end ? "last" : std::to_string(p.first_field() + row.offset);
        if (many && inner) offset.append(" +").append(std::to_string(row.stride)).append("i");
        std::string name = inner ? "  ." : "";
        name += row.name;
        if (many && !inner) name.append("[").append(std::to_string(row.count)).append("]");
        std::string each = varies ? "the rest" : std::to_string(row.size);
        if (row.split != 0) each = std::to_string(row.split).append(" + ").append(std::to_string(row.size - row.split));
        else if (many && !inner) each += " each";
        rows.push_back({offset, each, name, std::string{row.type}, range_of(row), std::string{row.meaning}});
        if (row.constant != '\0') rows.push_back({std::to_string(p.first_field() + row.offset + row.size), "1", "letter", "u8", std::string(1, row.constant), ""});
    }
    if (p.protocol == protocol::daisy) rows.push_back({"LEN", "1", "CRC", "u8", "", "exclusive or of all bytes before it"});
    else if (p.protocol == protocol::gateway) rows.push_back({std::to_string(p.first_field() + p.size), "1", "ETX", "u8", "0x03", ""});
    print_table(out, rows);
    for (const layout_row& row : p.fields) print_flags(out, row);
}

template <class F>
std::vector<portrait> portraits() {
    std::vector<portrait> all;
    F::messages::each([&]<class M>() { all.push_back(draw<F, M>()); });
    return all;
}

void list_messages(output& out, const std::vector<portrait>& all) {
    std::vector<cells> rows;
    for (const portrait& p : all) rows.push_back({std::string{p.name}, kind(p), identity(p), size(p)});
    out.write(std::string{all.front().format} + "\n");
    print_table(out, rows);
}

std::vector<portrait> portraits(protocol p) {
    if (p == protocol::daisy) return portraits<daisy::format>();
    if (p == protocol::can) return portraits<can::format>();
    return portraits<gateway::format>();
}

int describe_message(output& out, const std::vector<portrait>& all, std::string_view name) {
    bool found = false;
    for (const portrait& p : all) {
        if (p.name != name) continue;
        if (found) out.write("\n");
        found = true;
        print_portrait(out, p);
    }
    if (found) return all_well;
    complain("describe: ", all.front().format, " has no message ", name, "; see trama describe ", all.front().format);
    return failed;
}

}  // namespace

int describe(const options& o) {
    output out(STDOUT_FILENO);
    int status = all_well;
    if (o.operands == 2) status = describe_message(out, portraits(o.protocol), o.message);
    else if (o.operands == 1) list_messages(out, portraits(o.protocol));
    else for (const protocol p : {protocol::daisy, protocol::can, protocol::gateway}) list_messages(out, portraits(p));
    out.flush();
    return status;
}

}  // namespace trama::tool
