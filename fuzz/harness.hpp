#pragma once
// The properties that fuzzing tries to break, written once for every wire format. A target is a few lines; see fuzz/targets/.
#include <cstring>

#include "census.hpp"
#include "choice.hpp"
#include "random_message.hpp"
#include "trama/core/print.hpp"
#include "trama/core/view.hpp"
#include "transcript.hpp"

namespace trama::fuzz {

/// Printing into a buffer that is too small by one says so and stays inside it; into one that fits, it fills it.
template <has_layout M>
void check_printing(const M& m) {
    static std::array<char, 16384> roomy;
    for (const notation n : {notation::json, notation::plain}) {
        const auto print = [&](std::span<char> out) { return n == notation::json ? to_json(m, out) : to_text(m, out); };
        const auto size = print(roomy);
        require(bool(size), "a message prints into 16 KiB");
        exact<char> tight(*size);
        require(print(tight.all()) == size, "a message prints into exactly the size it takes");
        require(std::equal(roomy.begin(), roomy.begin() + static_cast<std::ptrdiff_t>(*size), tight.all().begin()), "printing does not depend on the buffer");
        if (*size == 0) continue;
        exact<char> small(*size - 1);
        require(print(small.all()).code() == errc::buffer_too_small, "printing tells that the buffer is too small");
    }
}

/// validate, is_valid and the rules agree with each other.
template <has_layout M>
void check_validation(const M& m) {
    const auto all = validate(m);
    require(all.empty() == is_valid(m), "is_valid means no violation");
    for (const violation& v : all) {
        std::array<char, 128> path{};
        text_sink sink(path);
        print_path<M>(sink, v.field);
        require(sink.size() != 0 && !sink.full(), "a violation names a field");
        require(v.allowed != nullptr, "a violation says what is allowed");
        require(!v.allowed->names.empty() || !v.allowed->words.empty() || !v.allowed->allows(v.value), "a violation's value is not allowed");
    }
}

/// A view of the fields at `body`, which loaded as `m` with `e` for its outcome, says of each field what loading all of them does.
template <has_layout M>
void check_views(std::span<const std::uint8_t> body, const M& m, const error& e) {
    if constexpr (M::layout.fixed) {
        const view<M> fields(body.data());
        each_index<M>([&]<std::size_t I>() {
            constexpr auto member = std::remove_cvref_t<decltype(field_of<M, I>)>::member;
            const auto one = fields.template get<member>();
            if (e) require(e.field.field != I || one.error().code == errc::bad_number, "a view refuses the field that loading refuses");
            else require(bool(one) && *one == m.*member, "a view reads the field as loading does");
            if constexpr (requires { fields.template get<member>(0); })
                for (std::size_t i = 0; !e && i != (m.*member).size(); ++i) {
                    const auto element = fields.template get<member>(i);
                    if constexpr (requires { *element; }) require(bool(element) && *element == (m.*member)[i], "a view reads an element as loading does");
                }
        });
    }
}

/// Encodes `m` into heap blocks of exactly its size and one less, and checks the two encoders against each other.
template <wire_format F, class M>
std::vector<typename F::unit> encode_checked(const typename F::envelope& e, const M& m, bool& valid) {
    using unit = typename F::unit;
    std::array<unit, F::max_units + 1> wire{};
    const std::array<unit, F::max_units + 1> blank{};
    check_validation(m);
    const auto free = F::encode_unchecked(e, m, wire);
    if (!free) {
        require(wire == blank, "an encoder that refuses writes nothing");
        std::array<unit, F::max_units + 1> other{};
        require(!F::encode(e, m, other) && other == blank, "what even the unchecked encoder refuses is refused");
        valid = false;
        return {};
    }
    require(*free == F::encoded_size(m) && *free <= F::max_units, "encoded_size is the size");
    bool good = is_valid(m);
    if constexpr (requires { F::for_each_violation(e, m, [](const violation&) {}); }) F::for_each_violation(e, m, [&](const violation&) { good = false; });
    exact<unit> tight(*free);
    const auto strict = F::encode(e, m, tight.all());
    require(bool(strict) == good, "encode refuses exactly the messages with a violation");
    if (strict) require(std::equal(tight.all().begin(), tight.all().end(), wire.begin()), "both encoders write the same");
    else require(strict.code() == errc::out_of_range, "a violation is out_of_range");
    exact<unit> small(*free - 1);
    require(F::encode_unchecked(e, m, small.all()).code() == errc::buffer_too_small, "a buffer too small by one is refused");
    for (const unit& u : small.all()) require(u == unit{}, "a refused buffer is left alone");
    valid = good;
    return {wire.begin(), wire.begin() + static_cast<std::ptrdiff_t>(*free)};
}

/// Decoding `wire` alone must give `m` under `e` and nothing else.
template <wire_format F, class M>
void check_decodes_to(std::span<const typename F::unit> wire, const typename F::envelope& e, const M& m) {
    const exact<typename F::unit> copy(wire);
    typename F::decoder decoder;
    std::span<const typename F::unit> in = copy.all();
    const auto event = decoder.next(in);
    require(event.code == errc::ok && in.empty(), "what is encoded decodes as one packet");
    require(event.packet.envelope() == e, "the envelope comes back");
    const auto back = decode<M>(event.packet);
    require(bool(back) && *back == m, "decode(encode(m)) == m");
    check_validation(m);
}

/// A body that was loaded as `m`, in a packet made for it: framed, checked and told apart as what comes from outside is. False when no
/// packet holds it, or none that speaks for itself.
template <wire_format F, class M>
bool check_packet_of(std::span<const std::uint8_t> body, const M& m, dice d) {
    const auto envelope = traits<F>::template envelope_for<M>(d);
    std::array<typename F::unit, F::max_units> wire{};
    const auto size = F::encode_unchecked(envelope, m, wire);
    if (!size || !traits<F>::evident(envelope, m)) return false;
    const octets packet = traits<F>::with_body(traits<F>::octets_from(std::span<const typename F::unit>(wire).first(*size)), body);
    const auto units = traits<F>::units_from(packet);
    check_decodes_to<F>(std::span<const typename F::unit>(units), envelope, m);
    return true;
}

/// One body, typed, and in a packet of its own.
template <wire_format F>
int decode_one(std::span<const std::uint8_t> input) {
    if (input.empty()) return 0;
    at_choice<F>(input[0], [&]<class M>() {
        const octets bytes = body_in<M>(input);
        const exact<std::uint8_t> body{std::span<const std::uint8_t>(bytes)};
        M m{};
        const error e = load_body(body.all(), m);
        if (e.code != errc::bad_length) check_views(body.all(), m, e);
        if (e) {
            require(e.code == errc::bad_length || e.code == errc::bad_number, "a body is refused for its length or a number");
            require((e.code == errc::bad_number) == (e.field.field < M::layout.count), "a bad number has a field");
            return;
        }
        require(body_size(m) == bytes.size(), "a message takes as many octets as it was read from");
        check_validation(m);
        check_printing(m);
        if (!fits_wire(m)) return;
        exact<std::uint8_t> again(bytes.size());
        store_body(again.all().data(), m);
        M twin{};
        require(!load_body(std::span<const std::uint8_t>(again.all()), twin) && twin == m, "what was stored loads as the same message");
        // A message of one spelling may lie between octets that loading passes over, such as can's letter.
        if (traits<F>::one_spelling && !std::equal(bytes.begin(), bytes.end(), again.all().begin())) return;
        if (check_packet_of<F>(body.all(), m, dice(hash_of(input)))) census<F>::note(chosen<F>(input[0]));
    });
    return 0;
}

/// The whole input against any split of it: the same events, and at every call the checks of `listener`. A long input is split in one way
/// only, chosen by its content: more inputs a second find more than more splits of each.
template <wire_format F>
int stream(std::span<const std::uint8_t> input) {
    using unit = typename F::unit;
    const auto units = traits<F>::units_from(input);
    const auto whole = transcript<F>(std::span<const unit>(units));
    for (const record<F>& r : whole) census<F>::note(r);
    dice d(hash_of(input));
    const bool all = units.size() <= 256;
    constexpr bool falls_silent = requires(typename F::decoder x) { x.idle(); } || requires(typename F::decoder x) { x.tick(0); };
    const std::size_t way = d.below(falls_silent ? 4 : 3);
    if (all || way == 0) require(whole == transcript<F>(std::span<const unit>(units), [] { return 1; }), "one unit at a time says the same as all at once");
    if (all || way == 1) require(whole == transcript<F>(std::span<const unit>(units), [&] { return d.below(7); }), "chunks of 0..6 units say the same as all at once");
    if (all || way == 2) require(whole == transcript<F>(std::span<const unit>(units), [&] { return 1 + d.below(2 * F::max_units); }), "long chunks say the same as all at once");
    if constexpr (falls_silent) {
        if (!all && way != 3) return 0;
        // Silence at places that depend on the stream alone, each as long as its own number says.
        std::vector<std::size_t> places(3);
        for (auto& p : places) p = d.below(units.size() + 1);
        std::sort(places.begin(), places.end());
        const std::size_t silence = d.below(60);
        const auto with_silence = [&](auto chunk_size) {
            listener<F> l;
            std::size_t at = 0;
            for (const std::size_t stop : places) {
                while (at != stop) {
                    const std::size_t n = std::min<std::size_t>(stop - at, chunk_size());
                    l.feed(std::span<const unit>(units).subspan(at, n));
                    at += n;
                }
                l.idle();
                if constexpr (requires { units[0].time; }) l.tick((at == 0 ? 0 : units[at - 1].time) + silence);
            }
            l.feed(std::span<const unit>(units).subspan(at));
            l.finish();
            return std::move(l).records();
        };
        require(with_silence([&] { return units.size(); }) == with_silence([] { return 1; }), "silence at the same places says the same");
    }
    return 0;
}

/// The other way of writing the same message, where the format has one.
template <wire_format F, class M>
void check_other_spelling(const typename F::envelope& e, const M& m) {
    if constexpr (requires { traits<F>::other_spelling; }) {
        std::array<typename F::unit, F::max_units> wire{};
        const auto size = F::encode_unchecked(e, m, wire, traits<F>::other_spelling);
        require(bool(size) == fits_wire(m), "both spellings refuse the same");
        if (!size) return;
        require(*size == F::encoded_size(m), "both spellings take the same room");
        check_decodes_to<F>(std::span<const typename F::unit>(wire).first(*size), e, m);
    }
}

/// octets → message → octets, for every packet in the input; and value → octets → value, the value drawn from the input.
template <wire_format F>
int roundtrip(std::span<const std::uint8_t> input) {
    using unit = typename F::unit;
    const auto units = traits<F>::units_from(input);
    const exact<unit> stream{std::span<const unit>(units)};
    typename F::decoder decoder;
    read<F>(decoder, stream.all(), [&](const auto& event) {
        if (event.code != errc::ok) return;
        const auto bad = visit<F>(event.packet, [&]<class M>(const M& m) {
            bool valid = false;
            const auto wire = encode_checked<F>(event.packet.envelope(), m, valid);
            require(!wire.empty(), "what was decoded can be encoded, if need be unchecked");
            if constexpr (traits<F>::one_spelling) {
                std::vector<unit> given;
                for (const std::size_t at : units_of<F>(units, event)) given.push_back(units[at]);
                require(traits<F>::octets_from(std::span<const unit>(wire)) == traits<F>::octets_from(std::span<const unit>(given)), "encode(decode(b)) == b");
            }
            if (traits<F>::evident(event.packet.envelope(), m)) check_decodes_to<F>(std::span<const unit>(wire), event.packet.envelope(), m);
        });
        require(!bad || bad.code == errc::bad_number || bad.code == errc::bad_length, "a known packet has a message, or a bad number or length");
    });
    dice d(hash_of(input), input);
    F::messages::at(d.below(F::messages::count), [&]<class M>() {
        arena memory;
        const bool strange = d.one_in(4);
        M m = random_message<M>(d, memory);
        require(is_valid(m), "random messages are valid");
        if (strange) change_one_value(m, d, memory);
        if (strange && d.one_in(8)) break_shape(m, d);
        const auto e = traits<F>::template envelope_for<M>(d, strange);
        bool valid = false;
        const auto wire = encode_checked<F>(e, m, valid);
        require(valid || strange, "a valid message encodes");
        check_other_spelling<F>(e, m);
        if (!wire.empty() && traits<F>::evident(e, m)) check_decodes_to<F>(std::span<const unit>(wire), e, without_absent(m));
    });
    return 0;
}

}  // namespace trama::fuzz
