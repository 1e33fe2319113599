#pragma once

#include <concepts>
#include <span>
#include <utility>

#include "trama/core/validate.hpp"

namespace trama {

/// The messages of a format, in catalogue order.
template <class... Messages>
struct message_list {
    static constexpr std::size_t count = sizeof...(Messages);

    /// Calls `f.operator()<M>()` for every message.
    static constexpr void each(auto&& f) { (f.template operator()<Messages>(), ...); }
    /// Calls `f.operator()<M>()` for the message at `index`; nothing when there is none. Compilers make it a jump table.
    [[gnu::always_inline]] static constexpr void at(std::size_t index, auto&& f) {
        std::size_t i = 0;
        (void)((index == i++ && (f.template operator()<Messages>(), true)) || ...);
    }
    template <class M>
    static constexpr bool contains = (std::is_same_v<M, Messages> || ...);
};

template <class List, template <class> class Keep>
struct filtered;
template <template <class> class Keep>
struct filtered<message_list<>, Keep> { using type = message_list<>; };
template <class M, class... Rest, template <class> class Keep>
struct filtered<message_list<M, Rest...>, Keep> {
    template <class... Others>
    static message_list<M, Others...> behind(message_list<Others...>);
    using rest = typename filtered<message_list<Rest...>, Keep>::type;
    using type = typename std::conditional_t<Keep<M>::value, decltype(behind(rest{})), rest>;
};

template <class... Lists>
struct joined;
template <class... A>
struct joined<message_list<A...>> { using type = message_list<A...>; };
template <class... A, class... B, class... Rest>
struct joined<message_list<A...>, message_list<B...>, Rest...> : joined<message_list<A..., B...>, Rest...> {};
/// One list after the other.
template <class... Lists>
using join = typename joined<Lists...>::type;

/// What a decoder reports: a packet, an error, or `need_more`. Views live until the decoder's next call, and no longer than the chunk given to it.
template <class Packet>
struct basic_event {
    errc code = errc::need_more;            ///< `ok`: a packet. `unknown_message`: a packet that no table has. Else an error.
    Packet packet{};                        ///< Of `ok` and `unknown_message`; else empty.
    std::uint64_t offset = 0;               ///< First unit in the stream, from 0 or as `seek` said.
    std::uint64_t length = 0;               ///< Units that the event covers.
    std::span<const std::uint8_t> bytes{};  ///< Of an error: its first 256 bytes. In can the data of its frames, of `ok` too.

    /// True for a packet whose message is known.
    constexpr explicit operator bool() const noexcept { return code == errc::ok; }
};

/// What a decoder's slow path hands back. One object, larger than the event: handed out by reference, the input would live
/// in memory on the quick path too, and clang would do the same to an event that the call writes in place.
template <class Event, class Unit>
struct stepped {
    Event event;
    std::span<const Unit> rest;  ///< What is left of the input.

    /// `step` takes units from the front of the span that it gets and reports one event.
    constexpr stepped(std::span<const Unit> in, auto&& step) noexcept : event(step(in)), rest(in) {}
};

/// What every wire format offers, so that harnesses, tools and property tests are written once.
///
/// `unit` is what the medium delivers: a byte on a serial line or a socket, a frame on a CAN bus.
/// `packet` is a verified, still untyped message: envelope, identity and a view of the body.
template <class F>
concept wire_format = requires(typename F::decoder d, std::span<const typename F::unit>& in, const typename F::packet& p) {
    requires std::regular<typename F::unit>;
    typename F::messages;
    typename F::envelope;
    { F::name } -> std::convertible_to<std::string_view>;
    { F::max_units } -> std::convertible_to<std::size_t>;
    { d.next(in) } -> std::convertible_to<basic_event<typename F::packet>>;  // consumes a unit, reports, or says need_more
    { d.finish() };                                                          // the input ends here: `next` reports what is left
    { d.reset() };                                                           // forget everything but the counters
    { d.pending() } -> std::convertible_to<std::uint64_t>;                   // units consumed and not yet reported
    { d.counters() } -> std::convertible_to<const counters&>;
    { p.envelope() } -> std::convertible_to<typename F::envelope>;
    { p.index() } -> std::convertible_to<std::size_t>;                       // place in `messages`, or its count
    { p.body() } -> std::convertible_to<std::span<const std::uint8_t>>;      // the fields' bytes
};

/// The message of a packet, or why it is none: `unknown_message`, `bad_length`, `bad_number` with its field.
/// Views in the message live as long as the packet's bytes. Values are not judged: see `validate`.
template <has_layout M, class Packet>
    requires requires(const Packet& p) { p.key() == M::key; }
constexpr result<M> decode(const Packet& packet) noexcept {
    if (packet.key() != M::key) return errc::unknown_message;
    M m{};
    if (const error e = load_body(packet.body(), m)) return e;
    return m;
}

/// As `decode`, into an object that the caller reuses; `m` is unspecified on error.
template <has_layout M, class Packet>
    requires requires(const Packet& p) { p.key() == M::key; }
[[nodiscard]] constexpr error decode_into(const Packet& packet, M& m) noexcept {
    if (packet.key() != M::key) return {errc::unknown_message, {}};
    return load_body(packet.body(), m);
}

/// Calls `f(const M&)` with the packet's typed message. Returns why it could not.
template <wire_format F>
[[gnu::always_inline]] constexpr error visit(const typename F::packet& packet, auto&& f) {
    error e{errc::unknown_message, {}};
    F::messages::at(packet.index(), [&]<class M>() __attribute__((always_inline)) {
        M m;
        e = load_body(packet.body(), m);
        if (!e) f(std::as_const(m));
    });
    return e;
}

/// Calls `f(const event&)` for everything that `in` completes.
template <wire_format F>
[[gnu::always_inline]] constexpr void read(typename F::decoder& decoder, std::span<const typename F::unit> in, auto&& f) {
    for (;;) {
        auto event = decoder.next(in);  // not const: g++ 12 would keep it in memory instead of registers
        if (event.code == errc::need_more) return;
        f(event);
    }
}

/// As `read`, for an `f` that takes another way for each kind of message: a decoder that can tells the kind of the packet behind
/// before it calls `f`, so that the processor sooner finds out which way is next. `f` is compiled twice; like that of `read` it may
/// call anything of the decoder but `next`.
template <wire_format F>
[[gnu::always_inline]] constexpr void read_ahead(typename F::decoder& decoder, std::span<const typename F::unit> in, auto&& f) {
    if constexpr (requires { decoder.read_ahead(in, f); }) decoder.read_ahead(in, f);
    else read<F>(decoder, in, f);
}

}  // namespace trama
