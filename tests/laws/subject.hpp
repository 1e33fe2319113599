#pragma once
// What the laws need to know of a format beyond the wire_format concept: each of daisy_subject.hpp, can_subject.hpp
// and gateway_subject.hpp beside this file specialises `subject`. What is the same in all tests of a format is compiled once, in tests/subjects/.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "laws/random_message.hpp"
#include "trama/core/print.hpp"
#include "trama/core/wire_format.hpp"

namespace trama::test {

template <wire_format F>
struct subject;

/// What random traffic is made of.
enum class traffic { clean, damaged, garbage, hostile, periodic };
inline constexpr std::array all_traffic{traffic::clean, traffic::damaged, traffic::garbage, traffic::hostile, traffic::periodic};
constexpr std::string_view name_of(traffic kind) {
    constexpr std::array<std::string_view, 5> names{"clean", "damaged", "garbage", "hostile", "periodic"};
    return names[static_cast<std::size_t>(kind)];
}

/// A random message of the format as units, with addresses that fit it.
template <wire_format F>
std::vector<typename F::unit> random_units(rng& random, manners how) {
    std::array<typename F::unit, F::max_units> out{};
    std::size_t size = 0;
    memory views;
    F::messages::at(random.below(F::messages::count), [&]<class M>() {
        const auto m = random_message<M>(random, how, views);
        const auto written = F::encode_unchecked(subject<F>::template random_envelope<M>(random, how), m, out);
        if (written) size = *written;
    });
    return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// Loses, doubles, inserts or changes units at a few random places.
template <class Unit, class Change>
void damage(rng& random, std::vector<Unit>& units, std::size_t faults, Change change) {
    for (std::size_t i = 0; i != faults && !units.empty(); ++i) {
        const auto at = units.begin() + static_cast<std::ptrdiff_t>(random.below(units.size()));
        switch (random.below(5)) {
            case 0: units.erase(at); break;
            case 1: units.insert(at, Unit(*at)); break;
            case 2: { Unit other = *at; change(other); units.insert(at, other); break; }
            default: change(*at);
        }
    }
}

// ---- the tool's JSON line of an event, written from the specification

inline std::string text_of(auto&& print) {
    std::array<char, 16384> buffer;
    text_sink sink(buffer);
    print(sink);
    return sink.full() ? "does not fit" : std::string(sink.view());
}

template <wire_format F, has_layout M>
std::string fields_and_violations(const typename F::envelope& e, const M& m) {
    return text_of([&](text_sink& out) {
        out << ",\"fields\":";
        print_fields(out, m, notation::json);
        std::string_view before = ",\"violations\":[";
        const auto print = [&](const violation& v) {
            out << before << "{\"field\":\"";
            print_path<M>(out, v.field);
            out << "\",\"value\":" << v.value << ",\"allowed\":\"";
            out.allowed(*v.allowed) << "\"}";
            before = ",";
        };
        F::for_each_violation(e, m, print);
        for_each_violation(m, print);
        if (before == ",") out << ']';
    });
}

inline std::string bytes_member(std::span<const std::uint8_t> bytes) {
    return text_of([&](text_sink& out) { out << ",\"bytes\":\""; out.hex(bytes.first(std::min<std::size_t>(bytes.size(), 256))) << '"'; });
}

template <wire_format F>
std::string error_line(const auto& e, errc code, std::span<const std::uint8_t> bytes, const std::string& rest) {
    const std::string shown = code == errc::noise ? "" : bytes_member(bytes);
    return subject<F>::head(e) + ",\"error\":\"" + std::string(trama::name_of(code)) + '"' + shown + rest + '}';
}

/// The JSON line of `e`.
template <wire_format F, class Event>
std::string line_of(const Event& e) {
    if (e.code != errc::ok) return error_line<F>(e, e.code, e.bytes, subject<F>::error_tail(e));
    std::string tail;
    const error bad = visit<F>(e.packet, [&]<class M>(const M& m) { tail = subject<F>::template identity<M>(e) + fields_and_violations<F>(e.packet.envelope(), m); });
    if (!bad) return subject<F>::head(e) + tail + '}';
    F::messages::at(e.packet.index(), [&]<class M>() {
        tail = text_of([&](text_sink& out) { out << ",\"field\":\""; print_path<M>(out, bad.field); out << '"'; });
    });
    return error_line<F>(e, bad.code, subject<F>::raw(e), tail);
}

}  // namespace trama::test
