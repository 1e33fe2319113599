// One thing of each module, as a user of the installed library would write it.
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>

// windows.h defines these, and nothing keeps it from that.
#define near
#define far
#include <trama/trama.hpp>

namespace {

/// Prints a message as JSON; false when there is none.
template <class M>
bool show(const trama::result<M>& message) {
    std::array<char, 2048> line{};
    if (!message) return false;
    const auto size = trama::to_json(*message, line);
    if (!size) return false;
    std::printf("%.*s\n", static_cast<int>(*size), line.data());
    return true;
}

/// Encodes `m`, feeds it to a new decoder of its format, and prints what comes out.
template <class Format, class M>
bool there_and_back(const typename Format::envelope& envelope, const M& m) {
    std::array<typename Format::unit, Format::max_units> out{};
    const auto size = Format::encode(envelope, m, out);
    if (!size) return false;
    typename Format::decoder decoder;
    std::span<const typename Format::unit> in = std::span(out).first(*size);
    const auto event = decoder.next(in);
    return event && trama::decode<M>(event.packet) == trama::result<M>(m) && show(trama::decode<M>(event.packet));
}

}  // namespace

int main() {
    namespace daisy = trama::daisy;
    namespace can = trama::can;
    namespace gateway = trama::gateway;

    const daisy::envelope to_motor{daisy::board(1, 1), daisy::board(0, 0)};
    const bool good =
        there_and_back<daisy::format>(to_motor, daisy::dc_motor::set_direction{daisy::direction::counter_clockwise}) &&
        there_and_back<can::format>({can::master_1}, can::read_actuator{.node = 1, .message_id = 6, .actuator = 0}) &&
        there_and_back<gateway::format>({}, gateway::load{.msg_id = 7, .cart_id = 12, .cargo_id = "PALLET 9"});
    return good ? 0 : 1;
}
