#include "tool/decode.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <unistd.h>

#include "tool/hex.hpp"
#include "tool/output.hpp"
#include "tool/progress.hpp"
#include "tool/ranges.hpp"
#include "tool/stream_printer.hpp"

namespace trama::tool {

namespace {

std::string number(std::uint64_t n) { return std::to_string(n); }

/// Tells where hex input is at fault; of very many places only the first ones.
class hex_complaints {
public:
    void operator()(hex_reader::place at, std::string_view what) {
        if (++count_ <= most) complain("decode: line ", number(at.line), ", column ", number(at.column), ": ", what);
        else if (count_ == most + 1) complain("decode: further places are not told");
    }
    std::uint64_t count() const { return count_; }

private:
    static constexpr std::uint64_t most = 20;
    std::uint64_t count_ = 0;
};

template <wire_format F>
int decode_stream(const options& o, input& in) {
    output out(STDOUT_FILENO);
    const auto emit = [&](std::string_view line) { out.write(line); };
    stream_printer<F> p(o);
    hex_reader hex;
    hex_complaints complaints;
    progress shown(in.size());
    std::uint64_t done = 0;
    for (auto bytes = in.read(); !bytes.empty(); bytes = in.read()) {
        shown.at(done += bytes.size());
        if (o.hex) {
            std::array<unsigned char, 4096> part;
            for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), part.size()))) {
                const auto text = std::span{part}.first(std::min(bytes.size(), part.size()));
                std::copy_n(bytes.begin(), text.size(), text.begin());
                p.read(hex.read(text, complaints), emit);
            }
        } else {
            p.read(bytes, emit);
        }
        out.flush();
    }
    p.finish(emit);
    out.flush();
    hex.finish(complaints);
    return complaints.count() != 0 || p.at_fault() ? input_at_fault : all_well;
}

}  // namespace

int decode(const options& o) {
    if (o.ranged || o.jobs > 1) return decode_parts(o);
    input in(o.file);
    if (!in.error().empty()) {
        complain("decode: ", o.file, ": ", in.error());
        return failed;
    }
    switch (o.protocol) {
        case protocol::daisy: return decode_stream<daisy::format>(o, in);
        case protocol::can: return decode_stream<can::format>(o, in);
        case protocol::gateway: break;
    }
    return decode_stream<gateway::format>(o, in);
}

}  // namespace trama::tool
