#pragma once
/// The ends of every range: what stands inside passes, what stands outside is named, refused, and written only unchecked.

#include <gtest/gtest.h>

#include <string>

#include "golden/table.hpp"
#include "trama/core/print.hpp"

namespace trama::golden {

struct broken {
    std::string_view path;
    std::int64_t value = 0;
    std::string_view allowed;
};

/// A message with the violations that it must have, in the order of `validate`.
template <wire_format F, class M, std::size_t Count>
struct limit {
    using format = F;
    typename F::envelope envelope;
    M value;
    std::array<broken, Count> expected;
};
template <wire_format F, class M>
constexpr auto passes(const typename F::envelope& e, const M& m) {
    return limit<F, M, 0>{e, m, {}};
}
template <wire_format F, class M, class... More>
constexpr auto fails(const typename F::envelope& e, const M& m, const More&... expected) {
    return limit<F, M, sizeof...(More)>{e, m, {expected...}};
}

/// Values and encoders agree; paths and words are checked at run time, where there is a sink.
template <wire_format F, class M, std::size_t Count>
constexpr bool limit_holds(const limit<F, M, Count>& l) {
    const auto found = validate(l.value);
    if (found.size() != Count || is_valid(l.value) != (Count == 0)) return false;
    for (std::size_t i = 0; i != Count; ++i)
        if (found[i].value != l.expected[i].value) return false;
    if constexpr (Count == 0) return properties::round_trips<F>(l.envelope, l.value, 61);
    else return properties::round_trips_unchecked<F>(l.envelope, l.value, found[0].field);
}

/// A value that the wire has no room for: both encoders refuse it by its field and write nothing.
template <wire_format F, class M>
constexpr bool unwritable(const typename F::envelope& e, const M& m, field_ref field) {
    properties::page<F> out;
    const error expected{errc::out_of_range, field};
    if (is_valid(m) || validate(m).empty() || validate(m)[0].field != field) return false;
    return F::encode(e, m, out.all).error() == expected && F::encode_unchecked(e, m, out.all).error() == expected && out.untouched_from(0);
}

template <const auto& Table, std::size_t I>
struct limit_proof {
    static_assert(limit_holds(slot_at<I>(Table.list)), "row I of Table does not hold");
    static constexpr bool value = true;
};
template <const auto& Table>
inline constexpr bool limits_proven = []<std::size_t... I>(std::index_sequence<I...>) {
    return (limit_proof<Table, I>::value && ...);
}(Table.indices);

/// `path value allowed`, one line for each violation.
template <class M>
std::string violations_text(const M& m) {
    std::string all;
    for (const violation& v : validate(m)) {
        std::array<char, 512> buffer{};
        text_sink sink(buffer);
        print_path<M>(sink, v.field);
        sink << ' ' << v.value << ' ';
        sink.allowed(*v.allowed) << '\n';
        all += sink.view();
    }
    return all;
}

/// The path of the field that makes `decode` fail with bad_number; else what happened instead.
template <wire_format F, class M>
std::string bad_number_path(std::span<const typename F::unit> stream) {
    typename F::decoder d;
    std::span<const typename F::unit> in = stream;
    const auto event = d.next(in);
    if (event.code != errc::ok) return std::string(name_of(event.code));
    const auto m = decode<M>(event.packet);
    if (m || m.code() != errc::bad_number) return m ? "decodes" : std::string(name_of(m.code()));
    std::array<char, 64> buffer{};
    text_sink sink(buffer);
    print_path<M>(sink, m.error().field);
    M into{};
    EXPECT_EQ(decode_into(event.packet, into), m.error());
    EXPECT_EQ(visit<F>(event.packet, [](const auto&) {}), m.error());
    return std::string(sink.view());
}

template <class Table>
void check_limits(const Table& table) {
    std::size_t i = 0;
    each_row(table, [&](const auto& l) {
        SCOPED_TRACE("limit " + std::to_string(i++) + " of " + std::string(l.value.name));
        EXPECT_TRUE(limit_holds(l));
        std::string text;
        for (const broken& v : l.expected) {
            text += std::string(v.path) + ' ' + std::to_string(v.value) + ' ' + std::string(v.allowed);
            text += '\n';
        }
        EXPECT_EQ(violations_text(l.value), text);
    });
}

}  // namespace trama::golden
