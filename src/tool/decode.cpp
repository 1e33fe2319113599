#include "tool/decode.hpp"

#include <charconv>
#include <string>

#include <unistd.h>

#include "tool/event_line.hpp"
#include "tool/hex.hpp"
#include "tool/log_decoder.hpp"
#include "tool/output.hpp"
#include "tool/progress.hpp"
#include "tool/ranges.hpp"

namespace trama::tool {

namespace {

/// Decodes units as they come and prints what they complete.
template <wire_format F>
class printer {
public:
    explicit printer(bool text) : notation_(text ? notation::plain : notation::json) {}

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
    void flush() { out_.flush(); }
    int status() const { return at_fault_ ? input_at_fault : all_well; }

private:
    typename F::decoder decoder_;
    notation notation_;
    bool at_fault_ = false;
    output out_{STDOUT_FILENO};
    std::array<char, longest_line> buffer_;
};

std::string number(std::uint64_t n) { return std::to_string(n); }

/// Tells where hex input is at fault; of very many places only the first ones.
class hex_complaints {
public:
    void operator()(hex_reader::place at, std::string_view what = "no hex digit") {
        if (++count_ <= most) complain("decode: line ", number(at.line), ", column ", number(at.column), ": ", what);
        if (count_ == most) complain("decode: further places are not told");
    }
    std::uint64_t count() const { return count_; }

private:
    static constexpr std::uint64_t most = 20;
    std::uint64_t count_ = 0;
};

template <wire_format F>
int decode_bytes(const options& o, input& in) {
    printer<F> p(o.text);
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
                p.feed(hex.read(text, complaints));
            }
        } else {
            p.feed(bytes);
        }
        p.flush();
    }
    p.finish();
    if (const hex_reader::place* odd = hex.odd()) complaints(*odd, "the last hex digit has no partner");
    return complaints.count() == 0 ? p.status() : input_at_fault;
}

int decode_can(const options& o, input& in) {
    output out(STDOUT_FILENO);
    const auto emit = [&](std::string_view line) { out.write(line); };
    log_printer log(o);
    progress shown(in.size());
    std::uint64_t done = 0;
    for (auto bytes = in.read(); !bytes.empty(); bytes = in.read()) {
        shown.at(done += bytes.size());
        log.read(bytes, emit);
        out.flush();
    }
    log.finish(emit);
    out.flush();
    return log.at_fault() ? input_at_fault : all_well;
}

}  // namespace

int decode(const options& o) {
    if (o.ranged || o.jobs > 1) return decode_parts(o);
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
