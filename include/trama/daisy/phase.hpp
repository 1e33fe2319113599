#pragma once

#include "trama/daisy/recovery.hpp"

namespace trama::daisy {

/// What an intact packet says about the phase it was found in.
enum class standing : std::uint8_t {
    undocumented,  ///< Nothing: any bytes will do.
    documented,    ///< Little: a text that could be anything, an error that does not agree with itself.
    landmark,      ///< That packets begin here.
};

/// Judges whether a decoder that believes to be in step may accept a packet that proves nothing. From the first such
/// packet on a shadow reads the same bytes in search of packets of higher standing in another phase. One find is enough
/// to refuse an undocumented packet. A documented one is taken all the same if a landmark came directly before it: a
/// phase of documented packets only is as good as any.
class phase_judge {
public:
    using history = std::array<std::uint8_t, max_packet>;

    /// Forgets the phase, as after a fault.
    constexpr void reset() noexcept { *this = {}; }
    /// True when another landmark changes nothing.
    constexpr bool settled() const noexcept { return !watching_ && vouched_; }
    /// A landmark was accepted while the shadow was not reading.
    constexpr void confirm() noexcept { vouched_ = true; }

    /// Whether the decoder may accept `packet`, which is intact. Landmarks always are.
    /// `past` holds the bytes before it that the shadow has not done with.
    constexpr bool accepts(std::span<const std::uint8_t> packet, standing s, history& past) noexcept {
        if (!watching_) {
            if (s == standing::landmark) { confirm(); return true; }
            watching_ = true;
            size_ = at_ = boundary_ = 0;
        }
        const window w({past.data(), size_}, packet);
        const bool contradicted = search(w, s);
        if (contradicted && (s == standing::undocumented || (s == standing::documented && !vouched_))) return false;
        vouched_ = s == standing::landmark;
        if (watching_) keep(w, packet, past);
        return true;
    }

private:
    /// Runs the shadow over `w`, whose last packet begins at `size_`. True when it met a packet of another phase.
    constexpr bool search(const window& w, standing judged) noexcept {
        bool met = false;
        for (;;) {
            if (at_ == size_) {
                if (judged == standing::landmark) { watching_ = false; return met; }  // both phases agree
                ++at_;
            }
            const std::size_t left = w.size() - at_;
            const header h = judge_header(w, at_, std::min<std::size_t>(left, header_size + 1));
            if (h == header::unclear) return met;
            const std::size_t size = std::size_t{w[at_]} + 1;
            if (h == header::documented && size > left) {
                if (may_come(w)) return met;
                ++at_;
            } else if (h != header::documented || !outranks(w, judged)) {
                ++at_;
            } else if (is_boundary(w)) {
                at_ = size_;  // an accepted packet: the phases agreed there
            } else {
                met = true;
                at_ += size;
            }
        }
    }
    /// Whether to wait for the packet at the shadow's place, whose last byte has not come. Not if a short landmark lies
    /// inside it: that would be found too late otherwise, and held against the packets that follow.
    constexpr bool may_come(const window& w) const noexcept {
        std::size_t probe = at_ + 1;
        return !recovery::find_short_landmark(w, probe) || recovery::may_be_report(w, at_);
    }
    /// True when the whole packet at the shadow's place says more than the one that is judged.
    constexpr bool outranks(const window& w, standing judged) const noexcept {
        if (judged == standing::undocumented) return recovery::is_acceptable(w, at_);
        return recovery::is_intact(w, at_, w.size()) && recovery::is_landmark_at(w, at_);
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

    bool vouched_ = false;       ///< The packet accepted last was a landmark.
    bool watching_ = false;
    std::size_t size_ = 0;       ///< Bytes of the past.
    std::size_t at_ = 0;         ///< The shadow's place in past and packet.
    std::size_t boundary_ = 0;   ///< Start of an accepted packet, at or behind the shadow's place.
};

}  // namespace trama::daisy
