// The smallest useful program of daisy: decodes one kind of message from a stream and reads one field.
#include <array>
#include <cstdlib>

#include "trama/daisy/format.hpp"

using namespace trama;

int main(int argc, char** argv) {
    using message = daisy::dc_motor::get_encoder_reply;
    std::array<daisy::format::unit, daisy::format::max_units> wire{};
    const auto size = daisy::format::encode({{0}, daisy::board(1, 2)}, message{}, wire);
    long sum = 0;
    daisy::format::decoder decoder;
    for (int left = argc > 1 ? std::atoi(argv[1]) : 1; left > 0; --left) {
        read<daisy::format>(decoder, std::span<const daisy::format::unit>(wire).first(*size), [&](const auto& event) {
            if (const auto m = event ? decode<message>(event.packet) : result<message>(errc::unknown_message)) sum += m->count;
        });
    }
    return sum == 1 ? 1 : 0;
}
