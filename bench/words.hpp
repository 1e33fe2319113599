#pragma once
// What contenders come to: words of the fields, summed up. The timed code adds them, which costs next to nothing; the
// proof that goes before it uses a sum that depends on the place of every word and reads texts whole.
#include <concepts>
#include <type_traits>

#include "harness.hpp"
#include "trama/core/bytes.hpp"
#include "trama/core/layout.hpp"

namespace trama::bench {

struct plain_sum {
    std::uint64_t value = 0;
    [[gnu::always_inline]] void add(std::uint64_t word) { value += word; }
};
/// Swapped, lost or doubled words show. Sums of parts make the sum of the whole.
struct ordered_sum {
    static constexpr std::uint64_t base = 0x100000001B3;
    std::uint64_t value = 0, scale = 1;
    [[gnu::always_inline]] void add(std::uint64_t word) {
        value = value * base + word;
        scale *= base;
    }
    void add(const ordered_sum& part) {
        value = value * part.scale + part.value;
        scale *= part.scale;
    }
};

enum class task { framing, typed, validated, selected };
inline constexpr task all_tasks[] = {task::framing, task::typed, task::validated, task::selected};
constexpr const char* name_of(task t) {
    constexpr const char* names[] = {"framing", "typed", "validated", "two fields by view"};
    return names[static_cast<unsigned>(t)];
}

/// A number or an enumerator as a word.
[[gnu::always_inline]] constexpr std::uint64_t as_word(auto v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v)); }

/// Calls `f(word)` for all that a value holds. Of texts and bytes the timed code reads both ends, the proof everything.
template <bool Ordered, class V>
[[gnu::always_inline]] inline void each_word(const V& v, auto&& f) {
    if constexpr (std::is_enum_v<V> || std::integral<V>) {
        f(as_word(v));
    } else if constexpr (requires { v.columns; }) {
        const auto* p = reinterpret_cast<const std::uint8_t*>(v.columns.data());
        if constexpr (Ordered) for (const char c : v.columns) f(static_cast<std::uint8_t>(c));
        else f(load_le<std::uint64_t>(p) + load_le<std::uint16_t>(p + v.columns.size() - 2));
    } else if constexpr (requires { v.bytes(); }) {
        if constexpr (Ordered) {
            f(v.size());
            for (const std::uint8_t b : v.bytes()) f(b);
        } else {
            f(v.empty() ? 0 : v.size() + v[0] + v[v.size() - 1]);
        }
    } else if constexpr (has_layout<V>) {
        each_index_inline<V>([&]<std::size_t I>() __attribute__((always_inline)) { each_word<Ordered>(v.*field_of<V, I>.member, f); });
    } else {
        for (const auto& one : v) each_word<Ordered>(one, f);
    }
}

/// The sum of the words, as the timed code has it: an expression, of which g++ makes better code than of steps.
template <class V>
[[gnu::always_inline]] inline std::uint64_t word_of(const V& v) {
    if constexpr (has_layout<V>) {
        return [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
            return (std::uint64_t{0} + ... + word_of(v.*field_of<V, I>.member));
        }(std::make_index_sequence<V::layout.count>{});
    } else {
        std::uint64_t sum = 0;
        if constexpr (requires { v.begin(); } && !requires { v.columns; } && !requires { v.bytes(); })
            for (const auto& one : v) sum += word_of(one);
        else
            each_word<false>(v, [&](std::uint64_t word) __attribute__((always_inline)) { sum = word; });
        return sum;
    }
}

/// Adds the words of one message, `each(f)`: as one sum, or one by one in their order.
template <bool Ordered>
[[gnu::always_inline]] inline void add_words(std::conditional_t<Ordered, ordered_sum, plain_sum>& sum, auto&& each) {
    if constexpr (Ordered) {
        each([&](std::uint64_t word) { sum.add(word); });
    } else {
        std::uint64_t words = 0;
        each([&](std::uint64_t word) __attribute__((always_inline)) { words += word; });
        sum.add(words);
    }
}

/// Stands in an ordered sum behind a message that is invalid.
inline constexpr std::uint64_t invalid = 0xBAD;

/// Counts for one contender. A tally is returned through memory, which the loop would then write to; this one is not.
template <bool Ordered>
struct account {
    std::uint64_t messages = 0, errors = 0;
    std::conditional_t<Ordered, ordered_sum, plain_sum> sum{};

    [[gnu::always_inline]] void packet(std::uint64_t length) {
        ++messages;
        sum.add(length);
    }
    [[gnu::always_inline]] void error(std::uint64_t length, std::uint64_t code) {
        ++errors;
        if constexpr (Ordered) {
            sum.add(length);
            sum.add(code);
        }
    }
    /// Of one message, which is counted by itself: `each(f)` calls `f(word)` for every word.
    [[gnu::always_inline]] void words(auto&& each) { add_words<Ordered>(sum, each); }
    [[gnu::always_inline]] void count(bool valid) { errors += valid ? 0 : 1; }
    [[gnu::always_inline]] void mark(bool valid) {
        if constexpr (Ordered)
            if (!valid) sum.add(invalid);
    }
    [[gnu::always_inline]] void judge(bool valid) {
        count(valid);
        mark(valid);
    }
    tally result() const { return {messages, sum.value, errors}; }
};

}  // namespace trama::bench
