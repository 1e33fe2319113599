// Asks motor board 1 for its encoder and reads the answer out of what came over the serial line.
#include <cstdio>

#include "trama/daisy/format.hpp"
using namespace trama;

int main() {
    std::array<std::uint8_t, daisy::max_packet> out;
    const auto size = daisy::encode({daisy::board(1, 1), daisy::board(0, 0)}, daisy::dc_motor::get_encoder{}, out);
    if (!size) return 1;
    std::printf("request: %zu bytes, CRC %02x\n", *size, out[*size - 1]);

    const std::uint8_t line[] = {0x08, 0x00, 0x11, 0xC3, 0x56, 0x34, 0x12, 0x00, 0xAA};  // the answer, 1193046 counts
    std::span<const std::uint8_t> in = line;
    daisy::decoder decoder;
    for (auto event = decoder.next(in); event.code != errc::need_more; event = decoder.next(in)) {
        if (const auto reply = decode<daisy::dc_motor::get_encoder_reply>(event.packet))
            std::printf("board %02x: %d counts\n", event.packet.envelope().source.octet, reply->count);
        else if (!event)
            std::printf("%s at %llu\n", name_of(event.code).data(), static_cast<unsigned long long>(event.offset));
    }
}
