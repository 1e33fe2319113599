#pragma once
// Decoding daisy messages by hand, as one writes it without a schema: a switch over family and command.
#include <cstdint>
#include <cstring>
#include <variant>

namespace trama::bench::by_hand {

struct empty {};
struct one_byte { std::uint8_t a; };
struct two_bytes { std::uint8_t a, b; };
struct three_bytes { std::uint8_t a, b, c; };
struct five_bytes { std::uint8_t v[5]; };
struct count16 { std::int16_t count; };
struct level { std::uint16_t value; };
struct count32 { std::int32_t count; };
struct motor_speed { std::uint8_t direction; std::int16_t speed; };
struct readings { std::uint8_t sensors; std::uint8_t count; std::uint16_t values[8]; };
struct description { const std::uint8_t* text; std::size_t size; };
struct error { std::uint8_t code; const std::uint8_t* rejected; std::size_t size; std::uint8_t expected_crc; };
using body = std::variant<empty, one_byte, two_bytes, three_bytes, five_bytes, count16, level, count32, motor_speed, readings, description, error>;

/// 0..5 the groups, 6 common, 7 none.
inline unsigned family_of(unsigned destination, unsigned source, unsigned command) {
    if ((command & 0x40) == 0) return 6;
    unsigned group = (command & 0x80) != 0 ? source >> 4 : destination >> 4;
    if (group == 0) group = (command & 0x80) != 0 ? destination >> 4 : source >> 4;
    return group == 6 ? 4 : group < 6 ? group : 7;
}

template <class T>
T get(const std::uint8_t* p) {
    T v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

/// Calls `f(body)`; false when there is no such message or its size is wrong. The key is the family, then the command.
template <class F>
inline bool decode(unsigned key, const std::uint8_t* p, std::size_t n, F&& f) {
    const auto nothing = [&] { return n == 0 && (f(empty{}), true); };
    const auto bytes1 = [&] { return n == 1 && (f(one_byte{p[0]}), true); };
    const auto bytes2 = [&] { return n == 2 && (f(two_bytes{p[0], p[1]}), true); };
    const auto bytes3 = [&] { return n == 3 && (f(three_bytes{p[0], p[1], p[2]}), true); };
    const auto bytes5 = [&] { return n == 5 && (f(five_bytes{{p[0], p[1], p[2], p[3], p[4]}}), true); };
    const auto u16 = [&] { return n == 2 && (f(level{get<std::uint16_t>(p)}), true); };
    const auto i16 = [&] { return n == 2 && (f(count16{get<std::int16_t>(p)}), true); };
    const auto i32 = [&] { return n == 4 && (f(count32{get<std::int32_t>(p)}), true); };
    const auto speed = [&] { return n == 3 && (f(motor_speed{p[0], get<std::int16_t>(p + 1)}), true); };
    switch (key) {
        case 0x601: case 0x602: case 0x603: case 0x683: return nothing();
        case 0x681: case 0x682: f(description{p, n}); return true;
        case 0x604:
            if (n == 1 && p[0] != 0) { f(error{p[0], nullptr, 0, 0}); return true; }
            if (n < 7 || p[0] != 0) return false;
            f(error{0, p + 1, n - 2, p[n - 1]});
            return true;
        case 0x140: return bytes1();
        case 0x141: case 0x1CB: return speed();
        case 0x142: case 0x1C3: return i32();
        case 0x145: case 0x1C6: return i16();
        case 0x1C8: case 0x149: case 0x14A: return u16();
        case 0x143: case 0x144: case 0x146: case 0x147: case 0x148: case 0x14B: case 0x1C0: case 0x1C1: case 0x1C2: case 0x1C4:
        case 0x1C5: case 0x1C7: case 0x1C9: case 0x1CA: return nothing();
        case 0x240: case 0x2C2: case 0x244: case 0x2C6: case 0x24B: return bytes2();
        case 0x241: case 0x2C3: case 0x245: case 0x2C7: return bytes5();
        case 0x242: case 0x246: case 0x248: case 0x2CA: return bytes1();
        case 0x24C: return bytes3();
        case 0x243: case 0x247: case 0x249: case 0x24A: case 0x2C0: case 0x2C1: case 0x2C4: case 0x2C5: case 0x2C8: case 0x2C9:
        case 0x2CB: case 0x2CC: return nothing();
        case 0x340: case 0x341: case 0x342: case 0x3C3: case 0x344: case 0x345: case 0x346: return bytes1();
        case 0x347: return bytes2();
        case 0x3C4: case 0x3C5: {
            if (n < 1 || n != 1 + 2 * static_cast<std::size_t>(__builtin_popcount(p[0]))) return false;
            readings r{p[0], static_cast<std::uint8_t>(n / 2), {}};
            for (std::size_t i = 0; i != r.count; ++i) r.values[i] = get<std::uint16_t>(p + 1 + 2 * i);
            f(r);
            return true;
        }
        case 0x343: case 0x3C0: case 0x3C1: case 0x3C2: case 0x3C6: case 0x3C7: return nothing();
        case 0x4C2: case 0x444: case 0x445: case 0x446: return u16();
        case 0x440: case 0x441: case 0x442: case 0x443: case 0x4C0: case 0x4C1: case 0x4C3: case 0x4C4: case 0x4C5: case 0x4C6: return nothing();
        case 0x5C0: case 0x542: return u16();
        case 0x540: case 0x541: case 0x5C1: case 0x5C2: return nothing();
        default: return false;
    }
}

/// Writes the bodies whose size is fixed, and tells the size. What they are made of needs no swapping of bytes here.
template <class Body>
std::size_t store(std::uint8_t* p, const Body& m) {
    if constexpr (requires { m.speed; }) {
        p[0] = m.direction;
        std::memcpy(p + 1, &m.speed, sizeof m.speed);
        return 3;
    } else if constexpr (requires { m.text; } || requires { m.rejected; } || requires { m.values; } || std::is_empty_v<Body>) {
        return 0;
    } else {
        std::memcpy(p, &m, sizeof m);
        return sizeof m;
    }
}

/// Calls `f(word)` for the words that the bench sums over all fields; see `each_word`.
inline std::uint64_t word(std::int64_t v) { return static_cast<std::uint64_t>(v); }
template <bool Ordered>
void words_of(const std::uint8_t* p, std::size_t n, auto&& f) {
    if (!Ordered) return f(n == 0 ? 0 : n + p[0] + p[n - 1]);
    f(n);
    for (std::size_t i = 0; i != n; ++i) f(p[i]);
}
template <bool Ordered, class Body>
void words_of(const Body& m, auto&& f) {
    if constexpr (requires { m.rejected; }) { f(m.code); words_of<Ordered>(m.rejected, m.size, f); f(m.expected_crc); }
    else if constexpr (requires { m.text; }) words_of<Ordered>(m.text, m.size, f);
    else if constexpr (requires { m.values; }) { f(m.sensors); for (std::size_t i = 0; i != m.count; ++i) f(m.values[i]); }
    else if constexpr (requires { m.speed; }) { f(m.direction); f(word(m.speed)); }
    else if constexpr (requires { m.count; }) f(word(m.count));
    else if constexpr (requires { m.value; }) f(m.value);
    else if constexpr (requires { m.v; }) for (const std::uint8_t b : m.v) f(b);
    else if constexpr (requires { m.c; }) { f(m.a); f(m.b); f(m.c); }
    else if constexpr (requires { m.b; }) { f(m.a); f(m.b); }
    else if constexpr (requires { m.a; }) f(m.a);
}

template <class Body>
std::uint64_t sum_of(const Body& m) {
    std::uint64_t sum = 0;
    words_of<false>(m, [&](std::uint64_t w) { sum += w; });
    return sum;
}

/// What the document allows, as comparisons by hand.
inline bool valid(unsigned key, const one_byte& m) {
    switch (key) {
        case 0x140: return m.a <= 1;
        case 0x242: case 0x246: case 0x248: return m.a <= 4;
        case 0x2CA: return m.a <= 0x7F;
        case 0x340: case 0x341: return m.a <= 5;
        case 0x346: return m.a <= 3;
        default: return m.a <= 0x3F;  // masks of sensors
    }
}
inline bool valid(unsigned key, const two_bytes& m) {
    if (key == 0x24B) return m.a <= 5 && m.b <= 3;
    if (key == 0x347) return m.a <= 3 && m.b <= 1;
    return m.a <= 4 && m.b <= 180;
}
inline bool valid(unsigned, const three_bytes& m) { return m.a <= 5 && m.b <= 3 && m.c <= 1; }
inline bool valid(unsigned, const five_bytes& m) {
    bool good = true;
    for (const std::uint8_t b : m.v) good &= b <= 180;
    return good;
}
inline bool valid(unsigned, const level& m) { return m.value <= 1023; }
inline bool valid(unsigned, const motor_speed& m) { return m.direction <= 1; }
inline bool valid(unsigned, const readings& m) {
    unsigned bits = m.sensors;
    for (std::size_t i = 0; i != m.count; ++i, bits &= bits - 1) {
        const std::uint16_t most = (bits & 0x1F) != 0 ? 1023 : 30100;
        if (m.values[i] > most && !(most != 1023 && m.values[i] == 0xFFFF)) return false;
    }
    return m.sensors <= 0x3F;
}
template <class Any>
bool valid(unsigned, const Any&) { return true; }

}  // namespace trama::bench::by_hand
