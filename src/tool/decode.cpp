#include "tool/decode.hpp"

#include <charconv>
#include <string>

#include <unistd.h>

#include "tool/event_line.hpp"
#include "tool/hex.hpp"
#include "tool/lines.hpp"
#include "tool/output.hpp"

namespace trama::tool {

namespace {

/// Decodes units as they come and prints what they complete.
template <wire_format F>
class printer {
public:
    printer(typename F::decoder decoder, bool text) : decoder_(decoder), notation_(text ? notation::plain : notation::json) {}

    void feed(std::span<const typename F::unit> units) {
        read<F>(decoder_, units, [&](const typename F::event& e) {
            text_sink line(buffer_);
            at_fault_ = print_event<F>(line, e, notation_) || at_fault_;
            line << '\n';
            out_.write(line.view());
        });
    }
    void finish() {
        decoder_.finish();
        feed({});
        out_.flush();
    }
    void note(std::string_view line) {
        out_.write(line);
        at_fault_ = true;
    }
    void flush() { out_.flush(); }
    typename F::decoder& decoder() { return decoder_; }
    notation style() const { return notation_; }
    int status() const { return at_fault_ ? input_at_fault : all_well; }

private:
    typename F::decoder decoder_;
    notation notation_;
    bool at_fault_ = false;
    output out_{STDOUT_FILENO};
    std::array<char, longest_line> buffer_;
};

std::string number(std::uint64_t n) { return std::to_string(n); }

template <wire_format F>
int decode_bytes(const options& o, input& in) {
    printer<F> p({}, o.text);
    hex_reader hex;
    for (auto bytes = in.read(); !bytes.empty() && !hex.foreign(); bytes = in.read()) {
        if (o.hex) {
            std::array<unsigned char, 4096> part;
            for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), part.size()))) {
                const auto text = std::span{part}.first(std::min(bytes.size(), part.size()));
                std::copy_n(bytes.begin(), text.size(), text.begin());
                p.feed(hex.read(text));
            }
        } else {
            p.feed(bytes);
        }
        p.flush();
    }
    p.finish();
    if (!hex.foreign() && !hex.odd()) return p.status();
    const std::string line = number(hex.line()), column = number(hex.column());
    if (hex.foreign()) complain("decode: line ", line, ", column ", column, ": no hex digit; the input was read up to there");
    else complain("decode: line ", line, ", column ", column, ": the last hex digit has no partner");
    return input_at_fault;
}

int decode_can(const options& o, input& in) {
    printer<can::format> p(can::reassembler({can::central_master, can::master_1, can::master_2}, o.timeout), o.text);
    line_reader lines;
    const auto take = [&](std::string_view line, bool too_long) {
        const auto frame = too_long ? std::nullopt : parse_candump(line);
        if (!frame) {
            const std::string n = number(lines.number());
            return p.note(p.style() == notation::json ? "{\"protocol\":\"can\",\"line\":" + n + ",\"error\":\"bad_line\"}\n" : "protocol=can line=" + n + " error=bad_line\n");
        }
        p.decoder().tick(frame->time);
        p.decoder().seek(lines.number());
        p.feed({&*frame, 1});
    };
    for (auto bytes = in.read(); !bytes.empty(); bytes = in.read()) {
        lines.read(bytes, take);
        p.flush();
    }
    lines.finish(take);
    p.finish();
    return p.status();
}

}  // namespace

int decode(const options& o) {
    input in(o.file);
    if (!in.error().empty()) {
        complain("decode: ", o.file, ": ", in.error());
        return failed;
    }
    if (o.protocol == protocol::daisy) return decode_bytes<daisy::format>(o, in);
    if (o.protocol == protocol::gateway) return decode_bytes<gateway::format>(o, in);
    return decode_can(o, in);
}

}  // namespace trama::tool
