#pragma once

#include "trama/daisy/recovery.hpp"

namespace trama::daisy {

/// Judges whether a decoder that believes to be in step may accept a packet that proves nothing: an undocumented
/// one, or a text that could be anything. It keeps a ledger: landmarks of this phase add to its trust. From the first
/// such packet on a shadow reads the same bytes in search of landmarks in any other phase; each costs twice what one
/// in step earns. A false phase that is not itself made of documented packets runs out of trust.
class phase_judge {
public:
    using history = std::array<std::uint8_t, max_packet>;

    /// Forgets the phase, as after a fault.
    constexpr void reset() noexcept { *this = {}; }
    /// True while the shadow reads along; the decoder must then show every packet to `accepts`.
    constexpr bool watching() const noexcept { return watching_; }
    /// True when another landmark changes nothing.
    constexpr bool settled() const noexcept { return !watching_ && trust_ == most_trust; }
    /// A landmark was accepted while the shadow was not reading.
    constexpr void confirm() noexcept { trust_ = static_cast<std::uint8_t>(trust_ + (trust_ < most_trust ? 1 : 0)); }

    /// Whether the decoder may accept `packet`, which is intact. Landmarks always are.
    /// `past` holds the bytes before it that the shadow has not done with.
    constexpr bool accepts(std::span<const std::uint8_t> packet, bool landmark, history& past) noexcept {
        if (!watching_) {
            if (landmark) { confirm(); return true; }
            watching_ = true;
            size_ = at_ = boundary_ = 0;
        }
        const window w({past.data(), size_}, packet);
        const unsigned cost = 2 * search(w, landmark);
        if (!landmark && cost > trust_) return false;
        trust_ = static_cast<std::uint8_t>(cost < trust_ ? trust_ - cost : 0);
        if (landmark) confirm();
        if (watching_) keep(w, packet, past);
        return true;
    }

private:
    static constexpr std::uint8_t most_trust = 16;

    /// Runs the shadow over `w`, whose last packet begins at `size_`. Returns how many landmarks of another phase it met.
    constexpr unsigned search(const window& w, bool landmark) noexcept {
        unsigned finds = 0;
        for (;;) {
            if (at_ == size_) {
                if (landmark) { watching_ = false; return finds; }  // both phases agree
                ++at_;
            }
            const std::size_t left = w.size() - at_;
            const header h = judge_header(w, at_, std::min<std::size_t>(left, header_size + 1));
            if (h == header::unclear) return finds;
            const std::size_t size = std::size_t{w[at_]} + 1;
            if (h == header::documented && size > left) return finds;
            if (h != header::documented || w.xor_of(at_, size) != 0 || !recovery::is_landmark_at(w, at_)) {
                ++at_;
            } else if (is_boundary(w)) {
                at_ = size_;  // an accepted packet: the phases agreed there
            } else {
                ++finds;
                at_ += size;
            }
        }
    }
    /// True when the shadow stands where an earlier packet was accepted.
    constexpr bool is_boundary(const window& w) noexcept {
        while (boundary_ < at_ && boundary_ < size_) boundary_ += std::size_t{w[boundary_]} + 1;
        return at_ < size_ && boundary_ == at_;
    }
    /// Keeps the bytes from the shadow's place on.
    constexpr void keep(const window& w, std::span<const std::uint8_t> packet, history& past) noexcept {
        while (boundary_ < at_) boundary_ += std::size_t{w[boundary_]} + 1;
        boundary_ -= at_;
        const std::size_t old = at_ < size_ ? size_ - at_ : 0;
        for (std::size_t i = 0; i != old; ++i) past[i] = past[at_ + i];
        const std::size_t from = at_ < size_ ? 0 : at_ - size_;
        copy_bytes(past.data() + old, packet.data() + from, packet.size() - from);
        size_ = old + packet.size() - from;
        at_ = 0;
    }

    std::uint8_t trust_ = 0;     ///< 0..most_trust.
    bool watching_ = false;
    std::size_t size_ = 0;       ///< Bytes of the past.
    std::size_t at_ = 0;         ///< The shadow's place in past and packet.
    std::size_t boundary_ = 0;   ///< Start of an accepted packet, at or behind the shadow's place.
};

}  // namespace trama::daisy
