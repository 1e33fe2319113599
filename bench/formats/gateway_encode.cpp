// Encoding cart_state.
#include <charconv>

#include "encode.hpp"
#include "gateway.hpp"

namespace trama::bench {

namespace {

using gateway::cart_state;
using gateway::transit_order;

std::size_t by_library(std::span<const cart_state> in, std::span<std::uint8_t> out) {
    std::size_t at = 0;
    for (const cart_state& m : in)
        if (const auto size = gateway::encode(m, out.subspan(at))) at += *size;
    return at;
}

/// As one writes it first: to_string and padding.
class string_writer {
public:
    void number(std::int64_t v, std::size_t columns) {
        const std::string digits = std::to_string(v);
        record_ += std::string(columns - digits.size(), ' ') + digits;
    }
    template <std::size_t N>
    void text(const trama::text<N>& t) { record_ += std::string(t.columns.data(), N); }
    std::string record_ = "\002200";
};
/// to_chars into columns that were blanked.
class pointer_writer {
public:
    explicit pointer_writer(char* p) : p_(p) {}
    void number(std::int64_t v, std::size_t columns) {
        char digits[20];
        const auto end = std::to_chars(digits, digits + sizeof digits, v).ptr;
        const auto n = std::min(static_cast<std::size_t>(end - digits), columns);
        std::memset(p_, ' ', columns - n);
        std::memcpy(p_ + columns - n, digits, n);
        p_ += columns;
    }
    template <std::size_t N>
    void text(const trama::text<N>& t) {
        std::memcpy(p_, t.columns.data(), N);
        p_ += N;
    }
    char* p_;
};

template <class Writer>
void write(Writer& w, const transit_order& o) {
    w.number(static_cast<std::int64_t>(o.use), 1);
    w.number(static_cast<std::int64_t>(o.type), 3);
    w.number(o.node, 5);
    w.number(o.station_id, 5);
    w.number(o.station_type, 5);
    w.number(o.level, 2);
    w.text(o.options);
    w.text(o.transit_id);
    w.text(o.cargo_id);
    w.number(static_cast<std::int64_t>(o.phase), 1);
    w.text(o.inputs);
    w.text(o.outputs);
    w.text(o.last_command);
}
template <class Writer>
void write(Writer& w, const cart_state& m) {
    w.number(m.msg_id, 5);
    w.number(m.cart_id, 5);
    w.number(static_cast<std::int64_t>(m.cart_status), 4);
    w.number(static_cast<std::int64_t>(m.cart_phase), 1);
    w.number(m.ini_node, 5);
    w.number(m.rel_position, 3);
    w.number(m.end_node, 5);
    w.number(m.next_node, 5);
    w.number(m.speed_mms, 5);
    w.number(m.cross_confirmation_needed, 1);
    for (const auto& o : m.orders) write(w, o);
}

std::size_t by_strings(std::span<const cart_state> in, std::span<std::uint8_t> out) {
    std::size_t at = 0;
    for (const cart_state& m : in) {
        string_writer w;
        write(w, m);
        w.record_ += '\003';
        std::memcpy(out.data() + at, w.record_.data(), w.record_.size());
        at += w.record_.size();
    }
    return at;
}
std::size_t by_pointers(std::span<const cart_state> in, std::span<std::uint8_t> out) {
    auto* const begin = reinterpret_cast<char*>(out.data());
    pointer_writer w(begin);
    for (const cart_state& m : in) {
        std::memcpy(w.p_, "\002200", 4);
        w.p_ += 4;
        write(w, m);
        *w.p_++ = '\003';
    }
    return static_cast<std::size_t>(w.p_ - begin);
}

shared_inputs<cart_state> states(std::size_t bytes) {
    auto all = std::make_shared<std::vector<cart_state>>(bytes / gateway::max_record);
    dice d(34);
    arena memory;
    for (auto& m : *all) m = random_message<cart_state>(d, memory);
    return all;
}

void race_states(race& r, std::size_t bytes) {
    const auto inputs = states(bytes);
    encoding<std::uint8_t> e(r, inputs->size(), inputs->size() * gateway::max_record);
    e.add("trama", role::library, inputs, by_library);
    e.add("to_string", role::baseline, inputs, by_strings);
    e.add("to_chars", role::baseline, inputs, by_pointers);
}

}  // namespace

void add_gateway_encode(std::vector<entry>& all, const scale& sizes) {
    add_encoding(all, sizes, "gateway", "cart_state", race_states);
}

}  // namespace trama::bench
