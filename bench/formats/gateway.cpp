#include "gateway.hpp"

#include "limits.hpp"

namespace trama::bench {

namespace {

using F = gateway::format;
using namespace gateway_code;

/// Moves numbers to the left of their columns, each with even chance: clients in the field mix both.
template <has_layout M>
void mix_sides(std::uint8_t* p, dice& d);
template <class W>
void mix_side(std::uint8_t* p, dice& d) {
    if constexpr (requires { typename W::element; }) {
        for (std::size_t i = 0; i != W::count; ++i) mix_side<typename W::element>(p + i * W::element::size, d);
    } else if constexpr (requires { W::value::layout; }) {
        mix_sides<typename W::value>(p, d);
    } else if constexpr (requires { W::decimal; }) {
        if (d.one_in(2)) gateway::detail::justify_value_left<W>(p);
    }
}
template <has_layout M>
void mix_sides(std::uint8_t* p, dice& d) {
    each_index<M>([&]<std::size_t I>() { mix_side<typename decltype(field_of<M, I>)::wire_type>(p + M::layout.offsets[I], d); });
}

template <class M>
void append_record(stream<F>& s, dice& d) {
    arena memory;
    const std::size_t at = s.data.size();
    append(s, {}, random_message<M>(d, memory));
    mix_sides<M>(s.data.data() + at + 1 + gateway::type_size, d);
}

/// 85 % cart_state; the others are replies, circuit_state and orders.
void append_any(stream<F>& s, dice& d) {
    using namespace gateway;
    switch (d.below(20)) {
        case 0: return append_record<ack>(s, d);
        case 1: return d.one_in(2) ? append_record<transit_ack>(s, d) : append_record<nack>(s, d);
        case 2: return d.one_in(2) ? append_record<circuit_state>(s, d) : append_record<load>(s, d);
        default: return append_record<cart_state>(s, d);
    }
}
shared_stream<F> mixed(std::size_t bytes) { return std::make_shared<stream<F>>(make_stream<F>(bytes, 31, append_any)); }
shared_stream<F> garbage(std::size_t bytes) {
    stream<F> s;
    dice d(32);
    s.data.resize(bytes);
    for (auto& b : s.data) b = static_cast<std::uint8_t>(d.next());
    return std::make_shared<stream<F>>(std::move(s));
}
/// Records that begin over and over and never end.
shared_stream<F> hostile(std::size_t bytes) {
    stream<F> s;
    s.data.resize(bytes);
    for (std::size_t i = 0; i != bytes; ++i) s.data[i] = static_cast<std::uint8_t>("\002200"[i % 4]);
    return std::make_shared<stream<F>>(std::move(s));
}

void add(std::vector<entry>& all, const std::string& workload, std::size_t bytes, const std::string& task, const std::function<void(race&)>& fill) {
    race r{"gateway", workload, size_name(bytes), task, {}};
    all.push_back({r.id(), [r, fill]() mutable { fill(r); return r; }});
}
void add_limit(race& r, const shared_stream<F>& s) {
    add_whole<F>(r, s, "validity pass", role::limit, not_compared, check_printable);
}
constexpr auto all_chunks = {std::size_t{0}, std::size_t{65536}, std::size_t{1460}, std::size_t{64}, std::size_t{7}, std::size_t{1}};

void add_faulty(std::vector<entry>& all, const std::string& workload, std::size_t bytes, const std::function<shared_stream<F>()>& make) {
    add(all, workload, bytes, "framing", [=](race& r) {
        const auto s = make(), clean = mixed(bytes);
        add_limit(r, s);
        add_library<F>(r, s, framing<F>, {0, 1460});
        add_whole<F>(r, clean, "trama, clean records", role::limit, not_compared, [](bytes_in in) { return framing<F>(in, 0); });
    });
}

}  // namespace

void add_gateway(std::vector<entry>& all, const scale& sizes) {
    for (const std::size_t bytes : {sizes.large, sizes.small}) {
        add(all, "85 % cart_state", bytes, "framing", [=](race& r) {
            const auto s = mixed(bytes);
            add_limit(r, s);
            add_memory_limits(r, s->data);
            add_whole<F>(r, s, "strings", role::baseline, 1, framing_strings);
            add_whole<F>(r, s, "pointers", role::baseline, 1, framing_pointers);
            add_library<F>(r, s, framing<F>, all_chunks);
        });
        add(all, "85 % cart_state", bytes, "typed", [=](race& r) {
            const auto s = mixed(bytes);
            add_limit(r, s);
            add_whole<F>(r, s, "substr and stoull", role::baseline, 1, typed_strings<false>);
            add_whole<F>(r, s, "trim and from_chars", role::baseline, 1, typed_pointers<false>);
            add_library<F>(r, s, typed<F>, {0, 65536, 1460});
        });
        add(all, "85 % cart_state", bytes, "validated", [=](race& r) {
            const auto s = mixed(bytes);
            add_limit(r, s);
            add_whole<F>(r, s, "substr and stoull", role::baseline, 1, typed_strings<true>);
            add_whole<F>(r, s, "trim and from_chars", role::baseline, 1, typed_pointers<true>);
            add_library<F>(r, s, typed<F, true>, {0, 1460});
        });
        add(all, "85 % cart_state", bytes, "two fields by view", [=](race& r) {
            const auto s = mixed(bytes);
            add_limit(r, s);
            add_library<F>(r, s, selected<F>, {0});
            add_whole<F>(r, s, "trama, framing alone", role::limit, not_compared, [](bytes_in in) { return framing<F>(in, 0); });
        });
    }
    for (const auto& [name, one_in] : {std::pair{"session, no damage", 0}, std::pair{"session, 0.1 % damaged", 1000}, std::pair{"session, 1 % damaged", 100}}) {
        const auto rate = static_cast<std::uint64_t>(one_in);
        add_faulty(all, name, sizes.large, [=] {
            const auto good = mixed(sizes.large);
            return rate == 0 ? good : std::make_shared<stream<F>>(damaged(*good, rate, 183, 33));
        });
    }
    add_faulty(all, "garbage", sizes.large, [=] { return garbage(sizes.large); });
    add_faulty(all, "hostile", sizes.large, [=] { return hostile(sizes.large); });
    add_gateway_encode(all, sizes);
}

}  // namespace trama::bench
