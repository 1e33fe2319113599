#include "reference.hpp"

#include <array>
#include <charconv>

#include "reference/reference.hpp"
#include "tool/event_line.hpp"

namespace trama::bench {

template <class F>
lines library_lines(unit_span<F> in) {
    lines all;
    typename F::decoder decoder;
    if constexpr (std::is_same_v<F, can::format>) decoder.seek(1);  // lines of a log count from 1
    const auto note = [&](const typename F::event& e) {
        static std::array<char, tool::longest_line> memory;
        text_sink sink(memory);
        (void)tool::print_event<F>(sink, e, notation::json);
        all.emplace_back(sink.view());
    };
    read<F>(decoder, in, note);
    decoder.finish();
    read<F>(decoder, {}, note);
    return all;
}
template lines library_lines<daisy::format>(unit_span<daisy::format>);
template lines library_lines<can::format>(unit_span<can::format>);
template lines library_lines<gateway::format>(unit_span<gateway::format>);

namespace {

/// A frame as candump writes it. All come at once, since nothing shall time out.
std::string log_line(const can::frame& f) {
    std::array<char, 64> memory;
    text_sink out(memory);
    const std::uint32_t id = f.id | (f.error ? 0x20000000U : 0U);
    out << "(1.000000) can0 ";
    for (int shift = f.extended || f.error ? 28 : 8; shift >= 0; shift -= 4) out << "0123456789ABCDEF"[id >> shift & 15];
    out << '#';
    if (f.fd) out << "#0";
    if (f.remote) out << 'R';
    else out.hex(std::span(f.data).first(f.length));
    out << '\n';
    return std::string(out.view());
}

/// The number behind `"key":`; 0 if there is none.
std::uint64_t number_of(const std::string& line, const std::string& key) {
    const auto at = line.find('"' + key + "\":");
    std::uint64_t n = 0;
    if (at != std::string::npos) std::from_chars(line.data() + at + key.size() + 3, line.data() + line.size(), n);
    return n;
}
/// The error of a line; `ok` if it is none.
errc error_of(const std::string& line) {
    constexpr std::string_view key = ",\"error\":\"";
    const auto at = line.find(key);
    if (at == std::string::npos || line.find(",\"message\":") < at) return errc::ok;
    for (std::size_t code = 0; code != errc_count; ++code)
        if (line.compare(at + key.size(), name_of(static_cast<errc>(code)).size(), name_of(static_cast<errc>(code))) == 0) return static_cast<errc>(code);
    return errc::ok;
}

}  // namespace

template <>
lines reference_lines<daisy::format>(unit_span<daisy::format> in) { return trama_reference::daisy_lines(in); }
template <>
lines reference_lines<gateway::format>(unit_span<gateway::format> in) { return trama_reference::gateway_lines(in); }
template <>
lines reference_lines<can::format>(unit_span<can::format> in) {
    std::string log;
    for (const can::frame& f : in) log += log_line(f);
    return trama_reference::can_lines(log);
}

tally tally_of(const lines& all, task t) {
    account<true> a;
    for (const std::string& line : all) {
        const errc code = error_of(line);
        const std::uint64_t length = number_of(line, line.find("\"frames\":") != std::string::npos ? "frames" : "length");
        const bool framed = code == errc::ok || code == errc::bad_number || (code == errc::unknown_message && t == task::framing);
        if (framed) a.packet(length);
        else a.error(length, static_cast<std::uint64_t>(code));
        if (code == errc::bad_number && (t == task::typed || t == task::validated)) ++a.errors;
        if (code == errc::ok && t == task::validated) a.judge(line.find(",\"violations\":[") == std::string::npos);
    }
    return {a.messages, t == task::framing ? a.sum.value : 0, a.errors};
}

tally text_of(const lines& all) {
    ordered_sum sum;
    for (const std::string& line : all) each_word<true>(byte_view(std::span(reinterpret_cast<const std::uint8_t*>(line.data()), line.size())), [&](std::uint64_t word) { sum.add(word); });
    return {all.size(), sum.value, 0};
}

}  // namespace trama::bench
