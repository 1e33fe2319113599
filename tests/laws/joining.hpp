#pragma once
// Decoders that join a stream somewhere, compared with the one that read it from its beginning.

#include <gtest/gtest.h>

#include "laws/subject.hpp"

namespace trama::test {

/// One event with what it shows.
struct reported {
    std::uint64_t offset;
    std::size_t length;
    errc code;
    octets bytes;
    friend bool operator==(const reported&, const reported&) = default;
};

/// What a decoder reports of `stream` that begins at `from` or behind it, having joined at `join`. It calls
/// `after(decoder, place)` behind every event.
template <wire_format F>
std::vector<reported> reports_from(const octets& stream, std::size_t join, std::size_t from, auto&& after) {
    std::vector<reported> all;
    typename F::decoder decoder;
    decoder.seek(join);
    const auto note = [&](const auto& e) {
        const auto shown = e.code == errc::ok ? subject<F>::raw(e) : e.bytes;
        if (e.offset >= from) all.push_back({e.offset, e.length, e.code, {shown.begin(), shown.end()}});
        after(decoder, static_cast<std::size_t>(e.offset + e.length));
    };
    read<F>(decoder, std::span(stream).subspan(join), note);
    decoder.finish();
    read<F>(decoder, {}, note);
    return all;
}
template <wire_format F>
std::vector<reported> reports_from(const octets& stream, std::size_t join, std::size_t from) {
    return reports_from<F>(stream, join, from, [](const auto&, std::size_t) {});
}

/// Traffic of one kind between clean one.
template <wire_format F>
octets interrupted_stream(rng& random, traffic kind, std::size_t size) {
    octets stream;
    for (const traffic k : {traffic::clean, kind, traffic::clean, kind, traffic::clean}) append(stream, subject<F>::random_stream(random, k, size));
    return stream;
}

/// Calls `check(stream, cut)` for many cuts of streams of every kind, all of which follow from fixed seeds.
template <wire_format F>
void for_many_cuts(std::size_t size, std::size_t step, auto&& check) {
    for (const traffic kind : all_traffic)
        for (std::uint64_t seed = 1; seed != 7 && !testing::Test::HasFailure(); ++seed) {
            SCOPED_TRACE(testing::Message() << name_of(kind) << " traffic, seed " << seed);
            rng random(seed);
            const octets stream = interrupted_stream<F>(random, kind, size);
            for (std::size_t cut = 0; cut < stream.size() && !testing::Test::HasFailure(); cut += random.within(1, step)) check(stream, cut);
        }
}

}  // namespace trama::test
