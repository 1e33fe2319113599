#pragma once
// The command-line tool's lines, made in memory: what `trama decode` prints and what `trama encode` reads.
#include <cstring>

#include "reference_of.hpp"
#include "samples.hpp"
#include "tool/encode_line.hpp"
#include "tool/event_line.hpp"
#include "tool/log_decoder.hpp"

namespace trama::fuzz {

template <wire_format F>
std::string line_of(const typename F::event& e) {
    static std::array<char, tool::longest_line> memory;
    text_sink sink(memory);
    (void)tool::print_event<F>(sink, e, notation::json);
    require(!sink.full(), "a line has room in longest_line");
    return std::string(sink.view());
}

/// What the library says about a stream; for octet formats.
template <wire_format F>
text_lines library_lines(std::span<const std::uint8_t> stream, std::span<const std::size_t> idle_at = {}) {
    text_lines lines;
    typename F::decoder decoder;
    const auto note = [&](const typename F::event& e) { lines.push_back(line_of<F>(e)); };
    const auto feed = [&](std::span<const std::uint8_t> part) {
        const exact<std::uint8_t> copy(part);
        read_ahead<F>(decoder, copy.all(), note);
    };
    std::size_t at = 0;
    for (const std::size_t stop : idle_at) {
        feed(stream.subspan(at, stop - at));
        at = stop;
        if constexpr (requires { decoder.idle(); }) decoder.idle();
        read<F>(decoder, {}, note);
    }
    feed(stream.subspan(at));
    decoder.finish();
    read<F>(decoder, {}, note);
    return lines;
}

/// What the library says about a candump log that comes in pieces; `next_piece(left)` says how long the next one is.
inline text_lines library_can_lines(std::string_view log, std::uint64_t timeout, auto&& next_piece) {
    text_lines lines;
    const auto note = [&](const can::event& e) { lines.push_back(line_of<can::format>(e)); };
    const auto note_bad = [&](std::uint64_t number) {
        std::array<char, 128> memory;
        text_sink sink(memory);
        tool::print_bad_line(sink, number, notation::json);
        lines.emplace_back(sink.view());
    };
    tool::log_decoder decoder(timeout);
    while (!log.empty()) {
        const std::string_view piece = log.substr(0, next_piece(log.size()));
        log.remove_prefix(piece.size());
        const exact<std::uint8_t> copy(std::span(reinterpret_cast<const std::uint8_t*>(piece.data()), piece.size()));
        decoder.read(copy.all(), note, note_bad);
    }
    decoder.finish(note, note_bad);
    return lines;
}

/// The same whole and in pieces. Each line is parsed in a block of its own size besides, since the decoder's has room behind it.
inline text_lines library_can_lines(std::string_view log, std::uint64_t timeout) {
    dice d(hash_of({reinterpret_cast<const std::uint8_t*>(log.data()), log.size()}));
    const auto whole = library_can_lines(log, timeout, [](std::size_t left) { return left; });
    const std::size_t longest = d.one_in(4) ? 3 : 100;
    require(whole == library_can_lines(log, timeout, [&](std::size_t left) { return 1 + d.below(std::min(left, longest)); }), "a log says the same however it is split");
    for (std::string_view rest = log; !rest.empty();) {
        const exact<char> line(std::span<const char>(rest).first(std::min(rest.find('\n'), rest.size())));
        (void)tool::parse_candump({line.all().data(), line.all().size()});
        rest.remove_prefix(std::min(rest.size(), line.all().size() + 1));
    }
    return whole;
}

inline void require_same(const text_lines& library, const text_lines& reference, const char* property) {
    if (library == reference) return;
    for (std::size_t i = 0; i != std::max(library.size(), reference.size()); ++i) {
        const char* a = i < library.size() ? library[i].c_str() : "(nothing)";
        const char* b = i < reference.size() ? reference[i].c_str() : "(nothing)";
        if (std::strcmp(a, b) != 0) std::fprintf(stderr, "line %zu\n  library:   %s\n  reference: %s\n", i + 1, a, b);
    }
    require(false, property);
}

/// What each side makes of a line of JSON, as octets or as a log; nothing where it is refused.
template <wire_format F>
std::optional<octets> library_encodes(std::string_view line, bool unchecked) {
    const auto e = tool::encode_line<F>(line, unchecked);
    if (!e.error.empty()) return std::nullopt;
    if constexpr (std::is_same_v<F, can::format>) {
        octets log;
        for (const auto& f : e.units) {
            std::array<char, 64> memory;
            text_sink sink(memory);
            tool::print_candump(sink, f);
            log.insert(log.end(), sink.view().begin(), sink.view().end());
        }
        return log;
    } else {
        return e.units;
    }
}
template <wire_format F>
void check_encoders(std::string_view line) {
    for (const bool unchecked : {false, true}) {
        const auto a = library_encodes<F>(line, unchecked), b = reference_of<F>::encode(line, unchecked);
        if (a != b) std::fprintf(stderr, "line:      %.*s\nlibrary:   %s\nreference: %s\n", static_cast<int>(line.size()), line.data(),
                                 a ? std::string(a->begin(), a->end()).c_str() : tool::encode_line<F>(line, unchecked).error.c_str(),
                                 b ? std::string(b->begin(), b->end()).c_str() : "(refused)");
        require(a.has_value() == b.has_value(), unchecked ? "library and reference refuse the same lines, unchecked" : "library and reference refuse the same lines");
        require(a == b, "library and reference encode a line alike");
    }
}

}  // namespace trama::fuzz
