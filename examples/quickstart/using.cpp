// Reads records off a socket whatever they are, passes on what the document does not know, and writes what it does not allow.
#include <cstdio>

#include "trama/trama.hpp"
using namespace trama;

/// Writes a line of whatever `f(text_sink&)` puts into it.
void print(auto&& f) {
    std::array<char, 4096> memory;
    text_sink line(memory);
    f(line);
    std::printf("%.*s\n", static_cast<int>(line.size()), line.view().data());
}

/// A message of any type: its JSON, its fields, and what the document does not allow in it.
template <has_layout M>
void show(const M& m) {
    std::array<char, 4096> json;
    if (const auto size = to_json(m, json)) std::printf("%s %.*s\n", M::name.data(), static_cast<int>(*size), json.data());
    for_each_row<M>([](const layout_row& row) { std::printf("  at %zu: %s, %s\n", row.offset, row.name.data(), row.meaning.data()); });
    for (const violation& v : validate(m))
        print([&](text_sink& line) {
            line << "  violation: ";
            print_path<M>(line, v.field);
            line << " is " << v.value << ", allowed ";
            line.allowed(*v.allowed);
        });
}

void take(const gateway::event& event) {
    if (event.code == errc::unknown_message) std::printf("type %u is unknown, %zu bytes to pass on\n", event.packet.type(), event.packet.bytes().size());
    else if (!event) std::printf("%s, %llu bytes\n", name_of(event.code).data(), static_cast<unsigned long long>(event.length));
    else if (const error e = visit<gateway::format>(event.packet, [](const auto& m) { show(m); }))
        gateway::messages::at(event.packet.index(), [&]<class M>() {
            print([&](text_sink& line) { line << M::name << ": " << name_of(e.code) << " in "; print_path<M>(line, e.field); });
        });
}

int main() {
    constexpr char socket[] = "\x02" " 15    1   12   42" "\x03"  // a cart is sent to node 42
                              "\x02" "210 new in town" "\x03"     // no documented type
                              "\x02" " 15    2   1x   42" "\x03"  // cart 1x
                              "??";                               // outside of any record
    gateway::decoder decoder;
    read<gateway::format>(decoder, {reinterpret_cast<const std::uint8_t*>(socket), sizeof socket - 1}, take);

    gateway::load order{.msg_id = 3, .cart_id = 12, .station_id = 301, .level = 17};
    std::array<std::uint8_t, gateway::max_record> out;
    if (!gateway::encode(order, out)) show(order);                  // refused: level is 17
    const auto size = gateway::encode_unchecked(order, out);        // written all the same
    decoder.finish();                                               // the noise ends here, too
    read<gateway::format>(decoder, {}, take);
    std::printf("%zu bytes written, %llu packets read\n", size.value_or(0), static_cast<unsigned long long>(decoder.counters().packets));
}
