#pragma once

#include <optional>

#include "trama/core/wire_format.hpp"

namespace trama {

/// Reads single fields of a fixed message out of its packet, without decoding the others. Lives as long as the packet.
template <has_layout M>
    requires(M::layout.fixed)
class view {
public:
    /// Precondition: `bytes` are the `M::layout.size` bytes of an `M`'s fields. `view_as` checks it.
    constexpr explicit view(const std::uint8_t* bytes) noexcept : bytes_(bytes) {}

    /// The field that `Member` points to, `bad_number` if it is malformed. `view<cart_state>::get<&cart_state::speed_mms>()`.
    template <auto Member>
        requires(index_of<M, Member>() < M::layout.count)
    constexpr auto get() const noexcept {
        constexpr std::size_t I = index_of<M, Member>();
        using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
        return read<typename one::wire_type, typename one::value, M::layout.size - M::layout.offsets[I]>(bytes_ + M::layout.offsets[I], {static_cast<std::uint8_t>(I)});
    }
    /// Element `i` of an array: its value, or of nested structures a view. Precondition: the array has it.
    template <auto Member>
        requires(index_of<M, Member>() < M::layout.count && requires { typename member_traits<decltype(Member)>::value::value_type; })
    constexpr auto get(std::size_t i) const noexcept {
        constexpr std::size_t I = index_of<M, Member>();
        using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
        using element = typename one::wire_type::element;
        const std::uint8_t* at = bytes_ + M::layout.offsets[I] + i * element::size;
        if constexpr (has_layout<typename one::value::value_type>) return view<typename one::value::value_type>(at);
        else return read<element, typename one::value::value_type, element::size>(at, {static_cast<std::uint8_t>(I), static_cast<std::uint8_t>(i)});
    }

private:
    /// `Readable` bytes of the message lie at `p`.
    template <class W, class V, std::size_t Readable>
    static constexpr result<V> read(const std::uint8_t* p, field_ref at) noexcept {
        V v{};
        std::uint64_t bad = 0;
        if constexpr (requires { &W::template load_near<Readable>; }) {
            typename W::value raw{};
            bad = W::template load_near<Readable>(p, raw);
            v = static_cast<V>(raw);
        } else {
            bad = load_value<W>(p, v);
        }
        if (bad != 0) return error{errc::bad_number, at};
        return v;
    }
    const std::uint8_t* bytes_;
};

/// A view of the packet's fields as an `M`; nothing when it is another message.
template <has_layout M, class Packet>
    requires(M::layout.fixed && requires(const Packet& p) { p.key() == M::key; })
constexpr std::optional<view<M>> view_as(const Packet& packet) noexcept {
    if (packet.key() != M::key || packet.body().size() != M::layout.size) return std::nullopt;
    return view<M>(packet.body().data());
}

}  // namespace trama
