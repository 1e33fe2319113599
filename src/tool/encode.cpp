#include "tool/encode.hpp"

#include <array>
#include <span>
#include <string>

#include <unistd.h>

#include "tool/encode_line.hpp"
#include "tool/lines.hpp"
#include "tool/output.hpp"

namespace trama::tool {

namespace {

template <wire_format F>
void write_units(output& out, std::span<const typename F::unit> units, bool hex) {
    if constexpr (std::is_same_v<F, can::format>) {
        for (const can::frame& f : units) {
            std::array<char, 64> memory;
            text_sink line(memory);
            print_candump(line, f);
            out.write(line.view());
        }
    } else if (hex) {
        std::array<char, 1024> memory;
        text_sink line(memory);
        line.hex(units, " ") << '\n';
        out.write(line.view());
    } else {
        out.write(units);
    }
}

template <wire_format F>
int encode_lines(const options& o, input& in) {
    output out(STDOUT_FILENO);
    line_reader lines;
    int status = all_well;
    const auto take = [&](std::string_view line, bool too_long) {
        if (!too_long && line.find_first_not_of(" \t\r") == line.npos) return;
        const encoded<F> packet = too_long ? encoded<F>{{}, "the line is too long"} : encode_line<F>(line, o.unchecked);
        if (packet.error.empty()) return write_units<F>(out, packet.units, o.hex);
        complain("encode: line ", std::to_string(lines.number()), ": ", packet.error);
        status = input_at_fault;
    };
    for (auto bytes = in.read(); !bytes.empty(); bytes = in.read()) {
        lines.read(bytes, take);
        out.flush();
    }
    lines.finish(take);
    out.flush();
    return status;
}

}  // namespace

int encode(const options& o) {
    input in(o.file);
    if (!in.error().empty()) {
        complain("encode: ", o.file, ": ", in.error());
        return failed;
    }
    if (o.protocol == protocol::daisy) return encode_lines<daisy::format>(o, in);
    if (o.protocol == protocol::gateway) return encode_lines<gateway::format>(o, in);
    return encode_lines<can::format>(o, in);
}

}  // namespace trama::tool
