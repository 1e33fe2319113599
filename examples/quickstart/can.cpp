// Puts the two frames of a node's answer together and prints its sensors.
#include <cstdio>

#include "trama/can/format.hpp"
using namespace trama;

int main() {
    std::array<can::frame, can::max_frames> out;
    const auto frames = can::encode({can::master_1}, can::read_sensors{2, 4}, out);
    if (!frames) return 1;
    std::printf("request: %zu frame of %d bytes\n", *frames, out[0].length);

    std::array<can::frame, 2> bus{};  // node 2 answers with four readings
    bus[0] = {can::master_1, 8, {2, 4, 'R', 4, 0, 100, 1, 240}};
    bus[1] = {can::master_1, 4, {2, 20, 3, 55}};
    std::span<const can::frame> in = bus;
    can::reassembler reassembler;
    const auto event = reassembler.next(in);
    const auto answer = decode<can::sensor_readings>(event.packet);
    if (!answer) return 1;
    for (const can::reading& r : answer->readings) std::printf("sensor %d: %d\n", r.sensor, r.value);
}
