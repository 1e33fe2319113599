// The smallest useful program of gateway: decodes one kind of message from a stream and reads one field.
#include <array>
#include <cstdlib>

#include "trama/gateway/format.hpp"

using namespace trama;

int main(int argc, char** argv) {
    using message = gateway::cart_state;
    std::array<gateway::format::unit, gateway::format::max_units> wire{};
    const auto size = gateway::format::encode({}, message{}, wire);
    long sum = 0;
    gateway::format::decoder decoder;
    for (int left = argc > 1 ? std::atoi(argv[1]) : 1; left > 0; --left) {
        read<gateway::format>(decoder, std::span<const gateway::format::unit>(wire).first(*size), [&](const auto& event) {
            if (const auto m = event ? decode<message>(event.packet) : result<message>(errc::unknown_message)) sum += m->speed_mms;
        });
    }
    return sum == 1 ? 1 : 0;
}
