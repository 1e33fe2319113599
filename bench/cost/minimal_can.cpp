// The smallest useful program of can: decodes one kind of message from a stream and reads one field.
#include <array>
#include <cstdlib>

#include "trama/can/format.hpp"

using namespace trama;

int main(int argc, char** argv) {
    using message = can::actuator_state;
    std::array<can::format::unit, can::format::max_units> wire{};
    const auto size = can::format::encode({can::master_1}, message{}, wire);
    long sum = 0;
    can::format::decoder decoder;
    for (int left = argc > 1 ? std::atoi(argv[1]) : 1; left > 0; --left) {
        read<can::format>(decoder, std::span<const can::format::unit>(wire).first(*size), [&](const auto& event) {
            if (const auto m = event ? decode<message>(event.packet) : result<message>(errc::unknown_message)) sum += m->state;
        });
    }
    return sum == 1 ? 1 : 0;
}
