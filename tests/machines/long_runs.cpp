// What is longer than 32 bits can count: runs of noise and a record without end. Exit status 1 if an event tells another length; takes a minute on an
// emulated machine, so that only tests/cross runs it.
#include <cstdio>
#include <vector>

#include "trama/trama.hpp"

using namespace trama;

namespace {

constexpr std::uint64_t much = (std::uint64_t{1} << 32) + 52;

/// Feeds `much` times `fill`, and is false if that is reported or lost.
template <class Decoder>
bool feed(Decoder& decoder, std::uint8_t fill) {
    const std::vector<std::uint8_t> chunk(1 << 24, fill);
    const std::uint64_t before = decoder.pending();
    for (std::uint64_t left = much; left != 0;) {
        const auto n = static_cast<std::size_t>(left < chunk.size() ? left : chunk.size());
        std::span<const std::uint8_t> in(chunk.data(), n);
        left -= n;
        if (decoder.next(in).code != errc::need_more || !in.empty()) return false;
    }
    return decoder.pending() == before + much;
}
bool is(const char* what, const auto& event, errc code, std::uint64_t length) {
    std::printf("%s: %s, %llu bytes\n", what, name_of(event.code).data(), static_cast<unsigned long long>(event.length));
    return event.code == code && event.offset == 0 && event.length == length && event.bytes.size() == 256;
}

}  // namespace

int main() {
    const std::uint8_t load[] = {gateway::stx, ' ', ' ', '1'}, end[] = {gateway::etx};  // a load has 57 bytes, 2^32 less than this one
    gateway::decoder records;
    std::span<const std::uint8_t> in = load;
    bool good = records.next(in).code == errc::need_more && feed(records, ' ');
    in = end;
    good = good && is("gateway", records.next(in), errc::bad_length, much + 5);
    daisy::decoder packets;
    good = feed(packets, 0xFF) && good;
    packets.finish();
    in = {};
    good = is("daisy", packets.next(in), errc::noise, much) && good;
    return good ? 0 : 1;
}
