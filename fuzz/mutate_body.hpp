#pragma once
// Mutations for `decode`, whose input is no stream: its first octet chooses a message, the rest is that message's body.
#include "choice.hpp"
#include "edit.hpp"
#include "random_message.hpp"
#include "samples.hpp"

namespace trama::fuzz {

/// `m` as input: nothing when the wire cannot carry it.
template <class M>
octets as_input(std::uint8_t choice, const M& m) {
    octets out{choice};
    if (!fits_wire(m)) return out;
    out.resize(1 + body_size(m));
    store_body(out.data() + 1, m);
    return out;
}

template <wire_format F>
octets random_body(std::uint8_t choice, bool strange, dice& d) {
    octets out;
    at_choice<F>(choice, [&]<class M>() {
        arena memory;
        M m = random_message<M>(d, memory);
        if (strange) change_one_value(m, d, memory);
        out = as_input(choice, m);
    });
    return out;
}

/// The same message with one value changed; the input itself where the body does not load or has no value.
template <wire_format F>
octets changed_body(std::span<const std::uint8_t> input, dice& d) {
    octets out(input.begin(), input.end());
    at_choice<F>(input[0], [&]<class M>() {
        arena memory;
        M m{};
        if (load_body(input.subspan(1), m)) return;
        change_one_value(m, d, memory);
        out = as_input(input[0], m);
    });
    return out;
}

/// Where a field of the body begins or ends, from the input's start; anywhere where that depends on the values.
template <wire_format F>
std::size_t some_field(std::span<const std::uint8_t> input, dice& d) {
    std::size_t at = 1 + d.below(input.size());
    at_choice<F>(input[0], [&]<class M>() {
        if constexpr (M::layout.fixed) at = 1 + M::layout.offsets[d.below(M::layout.count + 1)];
    });
    return std::min(at, input.size());
}

template <wire_format F>
std::size_t mutate_body(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    dice d(seed);
    if (plain_octets() || d.one_in(3)) return LLVMFuzzerMutate(data, size, max_size);
    octets input(data, data + size);
    std::size_t action = size == 0 ? 0 : d.below(10);
    if (action >= 2 && action < 6) {
        input = changed_body<F>(input, d);
        if (std::equal(input.begin(), input.end(), data, data + size)) action = 0;
    }
    if (action < 2) {
        input = random_body<F>(static_cast<std::uint8_t>(d.below(F::messages::count) | (d.one_in(4) ? 0x80U : 0U)), d.one_in(2), d);
    } else if (action == 6) {  // a field, or less, lost
        const std::size_t at = some_field<F>(input, d);
        erase(input, at, std::min(input.size() - at, 1 + d.below(d.one_in(2) ? 1 : 12)));
    } else if (action == 7) {
        insert(input, some_field<F>(input, d), octets(1 + d.below(d.one_in(2) ? 1 : 12), d.one_in(2) ? ' ' : static_cast<std::uint8_t>(d.next())));
    } else if (action == 8) {  // something else in a field's first octets: a sign, a digit, a space, anything
        const std::size_t at = some_field<F>(input, d) - (d.one_in(4) ? 1 : 0);
        if (at != 0 && at != input.size()) input[at] = d.one_in(2) ? static_cast<std::uint8_t>(d.next()) : static_cast<std::uint8_t>(" -0123456789A"[d.below(13)]);
    } else if (action == 9) {  // the same body as another message, or cut and filled to its size
        input[0] = static_cast<std::uint8_t>(d.one_in(2) ? input[0] ^ 0x80U : d.next());
    }
    if (d.one_in(8)) break_somewhere<F>(input, d);
    return hand_over(input, data, max_size);
}

/// The front of one body and the back of another, cut at a field of the first.
template <wire_format F>
std::size_t cross_bodies(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::uint8_t* out, std::size_t max_size, unsigned seed) {
    dice d(seed);
    if (a.empty()) return hand_over(b, out, max_size);
    const std::size_t cut = plain_octets() ? d.below(a.size() + 1) : some_field<F>(a, d);
    octets input = piece_of(a, 0, cut);
    insert(input, cut, b.subspan(std::min(cut, b.size())));
    return hand_over(input, out, max_size);
}

/// The body as a packet of its message, for `trama decode`: octet by octet as it is, whether it loads or not.
template <wire_format F>
void print_body(std::span<const std::uint8_t> input) {
    if (input.empty()) return;
    at_choice<F>(input[0], [&]<class M>() {
        const octets body = body_in<M>(input);
        M read{};
        if (const error e = load_body(std::span<const std::uint8_t>(body), read)) std::fprintf(stderr, "%s: the body does not load, %s\n", std::string(M::name).c_str(), std::string(name_of(e.code)).c_str());
        dice d(1);
        arena memory;
        std::array<typename F::unit, F::max_units> wire{};
        const auto size = F::encode_unchecked(traits<F>::template envelope_for<M>(d), random_message<M>(d, memory), wire);
        require(bool(size), "random messages encode");
        const octets packet = traits<F>::with_body(traits<F>::octets_from(std::span<const typename F::unit>(wire).first(*size)), body);
        if (packet.empty()) std::fprintf(stderr, "%s: no packet holds a body of %zu octets\n", std::string(M::name).c_str(), body.size());
        traits<F>::print_wire(packet);
    });
}

}  // namespace trama::fuzz
