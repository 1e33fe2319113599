#pragma once
/// What golden tables are checked for at run time.

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "golden/table.hpp"
#include "trama/core/print.hpp"

namespace trama::golden {

template <class M>
std::string fields_json(const M& m) {
    std::array<char, 4096> out{};
    const auto size = to_json(m, out);
    return size ? std::string(out.data(), *size) : std::string("does not fit");
}

/// What a decoder made of a stream: one line for each event.
template <wire_format F>
std::string transcript(std::span<const typename F::unit> stream, properties::cuts cut, bool& conserved) {
    typename F::decoder d;
    std::ostringstream out;
    conserved = properties::feed<F>(d, stream, cut, [&](const auto& event) {
        out << event.offset << '+' << event.length << ' ' << name_of(event.code) << ' ' << event.packet.index();
        for (const unsigned b : event.packet.body()) out << ' ' << b;
        out << '\n';
    });
    return out.str();
}

/// Every row holds, with every chunk size and every split point, and prints as it should.
template <class Table>
void check_rows(const Table& table) {
    each_row(table, [&](const auto& row) {
        SCOPED_TRACE(std::string(row.name) + ' ' + std::string(row.json));
        EXPECT_TRUE(holds(row, 1));
        EXPECT_TRUE(is_valid(row.value));
        EXPECT_EQ(row.name, row.value.name);
        EXPECT_EQ(fields_json(row.value), row.json);
    });
}

/// All rows one after the other, cut in two at every place and into chunks of every size up to 300: the same events.
template <class Table>
void check_stream(const Table& table) {
    using first = std::remove_cvref_t<decltype(slot_at<0>(table.list))>;
    using F = typename first::format;
    std::vector<typename F::unit> stream;
    std::size_t rows = 0;
    each_row(table, [&](const auto& row) { stream.insert(stream.end(), row.wire.begin(), row.wire.end()); ++rows; });
    bool conserved = false;
    const std::string whole = transcript<F>(stream, {stream.size(), stream.size()}, conserved);
    EXPECT_TRUE(conserved);
    EXPECT_EQ(static_cast<std::size_t>(std::count(whole.begin(), whole.end(), '\n')), rows);
    EXPECT_EQ(whole.find(" noise"), std::string::npos);
    for (std::size_t split = 1; split < stream.size(); ++split) {
        ASSERT_EQ(transcript<F>(stream, {split, stream.size()}, conserved), whole) << "split at " << split;
        ASSERT_TRUE(conserved) << "split at " << split;
    }
    for (std::size_t chunk = 1; chunk <= 300; ++chunk) {
        ASSERT_EQ(transcript<F>(stream, {chunk, chunk}, conserved), whole) << "chunks of " << chunk;
        ASSERT_TRUE(conserved) << "chunks of " << chunk;
    }
}

/// Fed with one unit damaged, a decoder never gives the row's message and nothing else, unless `same(row, damaged)` says
/// that the damage does not change what the units mean; and every unit is accounted for.
template <class Table>
void check_damage(const Table& table, auto&& each_damage, auto&& same) {
    each_row(table, [&](const auto& row) {
        using F = typename std::remove_cvref_t<decltype(row)>::format;
        using M = typename std::remove_cvref_t<decltype(row)>::message;
        SCOPED_TRACE(std::string(row.name) + ' ' + std::string(row.json));
        each_damage(row.wire, [&](const auto& damaged, std::size_t place, unsigned how) {
            for (const std::size_t chunk : {damaged.size(), std::size_t{1}, std::size_t{5}}) {
                typename F::decoder d;
                bool given = false;
                const bool conserved = properties::feed<F>(d, std::span<const typename F::unit>(damaged), properties::cuts{chunk, chunk}, [&](const auto& event) {
                    if (event.code != errc::ok || !(event.packet.envelope() == row.envelope)) return;
                    const auto back = decode<M>(event.packet);
                    given = given || (back && *back == row.value);
                });
                ASSERT_TRUE(conserved) << "place " << place << " damage " << how;
                ASSERT_EQ(given, same(row, damaged)) << "place " << place << " damage " << how;
            }
        });
    });
}

/// Every other value in place of each byte.
inline constexpr auto every_byte = [](const auto& wire, auto&& f) {
    for (std::size_t at = 0; at != wire.size(); ++at)
        for (unsigned by = 1; by != 256; ++by) {
            auto damaged = wire;
            damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ by);
            f(damaged, at, by);
        }
};
inline constexpr auto never_same = [](const auto&, const auto&) { return false; };

}  // namespace trama::golden
