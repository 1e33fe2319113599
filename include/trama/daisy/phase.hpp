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
/// packet on, and from the first one after a fault, a shadow reads the same bytes in search of packets in another phase.
/// What it finds there is a chain as long as one packet begins where the one before ends. It goes when it has been
/// through two landmarks in a row.
class phase_judge {
public:
    using history = std::array<std::uint8_t, max_packet>;

    /// What became of a packet. If a packet of the shadow's chain reaches over the start of a refused one, also where the
    /// other phase goes on: `resume` bytes behind the refused one's first, provided that their exclusive or is `sum`.
    struct verdict {
        std::size_t resume = 0;  ///< 0: not known.
        std::uint8_t sum = 0;
        bool accepted = true;
    };

    /// Forgets the phase, as after a fault.
    constexpr void reset() noexcept { *this = {}; }
    /// True when another landmark changes nothing.
    constexpr bool settled() const noexcept { return !watching_ && vouched_; }

    /// Begins with the first packet after a fault. `resumed`: it was announced by the verdict before.
    constexpr void begin(std::span<const std::uint8_t> packet, standing s, bool resumed, history& past) noexcept {
        watch(resumed ? most_trust : 0);
        accept(window({}, packet), packet, s, past);
    }
    /// Whether the decoder may accept `packet`, which is intact. Landmarks always are.
    /// `past` holds the bytes before it that the shadow has not done with.
    constexpr verdict judge(std::span<const std::uint8_t> packet, standing s, history& past) noexcept {
        if (!watching_) {
            if (s == standing::landmark) {
                vouched_ = true;
                return {};
            }
            watch(vouched_ ? most_trust : 0);
        }
        const window w({past.data(), size_}, packet);
        const bool contradicted = search(w, s);
        if (refuses(s, contradicted)) return refusal(w);
        doubted_ = s == standing::documented && contradicted;
        accept(w, packet, s, past);
        return {};
    }

private:
    static constexpr std::size_t most_trust = 3 * max_packet;

    constexpr void watch(std::size_t trust) noexcept {
        watching_ = true;
        trust_ = trust;
        chain_ = size_ = boundary_ = 0;
        at_ = probe_ = 1;
    }
    /// One find is enough to refuse an undocumented packet, and so is a chain that reaches over its start: its landmarks
    /// may all have ended in packets that were accepted. A documented packet is taken all the same if a landmark came
    /// directly before it, since a phase of documented packets only is as good as any; and if such packets have come for
    /// longer than the other phase's chain is.
    constexpr bool refuses(standing s, bool contradicted) const noexcept {
        if (s == standing::undocumented) return contradicted || doubted_ || (chain_ != 0 && at_ < size_);
        return s == standing::documented && contradicted && !vouched_ && trust_ <= chain_;
    }
    constexpr verdict refusal(const window& w) const noexcept {
        const std::size_t over = at_ > size_ ? link_ : at_;
        if (chain_ == 0 || over >= size_) return {0, 0, false};
        return {over + w[over] - size_, w.xor_of(over, size_ + 1 - over), false};
    }
    constexpr void accept(const window& w, std::span<const std::uint8_t> packet, standing s, history& past) noexcept {
        vouched_ = s == standing::landmark;
        trust_ = s == standing::undocumented ? 0 : std::min(trust_ + packet.size(), most_trust);
        if (watching_) keep(w, packet, past);
    }
    /// Runs the shadow over `w`, whose last packet begins at `size_`. True when it met a packet of another phase that
    /// speaks against the last one.
    constexpr bool search(const window& w, standing judged) noexcept {
        for (bool met = false;;) {
            if (at_ == size_ && judged == standing::landmark && vouched_) {  // both phases agree
                watching_ = false;
                return met;
            }
            const std::size_t left = w.size() - at_;
            const header h = judge_header(w, at_, std::min<std::size_t>(left, header_size + 1));
            if (h == header::unclear) return met;
            const std::size_t size = std::size_t{w[at_]} + 1;
            if (h == header::documented && size > left && may_come(w)) return met;
            if (h != header::documented || size > left || is_boundary(at_, w) || !recovery::is_acceptable(w, at_)) {
                chain_ = 0;
                ++at_;
                continue;
            }
            met = met || judged == standing::undocumented || recovery::is_landmark_at(w, at_);
            chain_ = std::min(chain_ + size, most_trust);
            link_ = at_;
            at_ += size;
        }
    }
    /// Whether to wait for the packet at the shadow's place, whose last byte has not come. Not if a short landmark of yet
    /// another phase lies inside it: that would be found too late otherwise, and held against the packets that follow.
    constexpr bool may_come(const window& w) noexcept {
        for (probe_ = std::max(probe_, at_ + 1); recovery::find_short_landmark(w, probe_); ++probe_)
            if (!is_boundary(probe_, w)) return recovery::may_be_report(w, at_);
        return true;
    }
    /// True when a packet that was accepted, or the one that is judged, begins at `place`, which is not before the shadow.
    constexpr bool is_boundary(std::size_t place, const window& w) noexcept {
        while (boundary_ < at_ && boundary_ < size_) boundary_ += std::size_t{w[boundary_]} + 1;
        std::size_t boundary = boundary_;
        while (boundary < place && boundary < size_) boundary += std::size_t{w[boundary]} + 1;
        return boundary == place;
    }
    /// Keeps the bytes from the shadow's place on.
    constexpr void keep(const window& w, std::span<const std::uint8_t> packet, history& past) noexcept {
        while (boundary_ < at_) boundary_ += std::size_t{w[boundary_]} + 1;
        boundary_ -= at_;
        probe_ -= std::min(probe_, at_);
        const std::size_t old = at_ < size_ ? size_ - at_ : 0;
        if (at_ != 0)
            for (std::size_t i = 0; i != old; ++i) past[i] = past[at_ + i];
        const std::size_t from = at_ < size_ ? 0 : at_ - size_;
        copy_bytes(past.data() + old, packet.data() + from, packet.size() - from);
        size_ = old + packet.size() - from;
        at_ = 0;
    }

    bool vouched_ = false;       ///< The packet accepted last was a landmark.
    bool doubted_ = false;       ///< The packet accepted last was taken only because of the landmark before it.
    bool watching_ = false;
    std::size_t trust_ = 0;      ///< Bytes of documented packets accepted in a row while watching, as far as it matters.
    std::size_t chain_ = 0;      ///< Bytes of packets of another phase in a row that end at the shadow's place, likewise.
    std::size_t size_ = 0;       ///< Bytes of the past.
    std::size_t at_ = 0;         ///< The shadow's place in past and packet.
    std::size_t link_ = 0;       ///< Where the last packet of the chain begins; of use only until the next packet is judged.
    std::size_t probe_ = 0;      ///< Up to here no packet at the shadow's place or behind can hold a short landmark.
    std::size_t boundary_ = 0;   ///< Start of an accepted packet, at or behind the shadow's place once `is_boundary` was asked.
};

}  // namespace trama::daisy
