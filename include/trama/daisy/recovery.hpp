#pragma once

#include "trama/daisy/candidate.hpp"

/// How the decoder finds its footing again after a fault. XOR is a weak check: in periodic traffic any window over
/// whole cycles XORs to zero too, so a good CRC alone proves nothing. docs/daisy.md draws the cases.
namespace trama::daisy::recovery {

inline constexpr std::size_t longest_short = 22;  ///< The longest packet that is neither text nor a rejected packet.

/// True when a whole packet with a documented header and a good CRC begins at `at`.
constexpr bool is_intact(const window& w, std::size_t at, std::size_t end) noexcept {
    const std::size_t size = std::size_t{w[at]} + 1;
    if (size > end - at || w.xor_of(at, size) != 0) return false;
    return judge_header(w, at, std::min<std::size_t>(end - at, header_size + 1)) == header::documented;
}

/// True when an intact packet that can hold nothing but numbers lies wholly behind the first byte of `whole`.
constexpr bool holds_short_packet(std::span<const std::uint8_t> whole) noexcept {
    const window w({}, whole);
    for (std::size_t q = next_candidate(w, 1); q + min_packet <= whole.size(); q = next_candidate(w, q + 1))
        if (is_intact(w, q, whole.size()) && !known.carries_bytes[index_of(w[q + 1], w[q + 2], w[q + 3])]) return true;
    return false;
}

/// True when an intact packet with the header of an `M` is more than a chance hit: a text must be plain and hold no
/// packet, a rejected packet must agree with its own CRC. Such a packet speaks for the phase it was found in.
template <class M>
constexpr bool is_landmark(std::span<const std::uint8_t> whole) noexcept {
    if constexpr (!carries_bytes<M>) {
        return true;
    } else {
        const auto body = whole.subspan(header_size, whole.size() - min_packet);
        if constexpr (is_text<M>) {
            // Printable text is plain, and no short packet begins in it: their LEN is a control character. Nor does one
            // begin in the header, since a response's command is no address.
            static_assert(longest_short <= ' ' && (command_of(M::key) & response_bit) != 0);
            if (all_printable(body.data(), body.size())) return true;
        }
        M m;
        if (load_body(body, m) || !m.evident()) return false;
        if constexpr (is_text<M>) return !holds_short_packet(whole);
        return true;
    }
}
constexpr bool is_landmark(std::span<const std::uint8_t> whole, std::size_t index) noexcept {
    if (known.fixed_len[index] != variable) return true;
    bool evident = false;
    for_variable(index, [&]<class M>() { evident = is_landmark<M>(whole); });
    return evident;
}

/// True when the intact packet at `at` is a landmark.
constexpr bool is_landmark_at(const window& w, std::size_t at) noexcept {
    const std::size_t index = index_of(w[at + 1], w[at + 2], w[at + 3]);
    if (known.fixed_len[index] != variable) return true;
    std::array<std::uint8_t, max_packet> spare;
    return is_landmark(w.piece(at, std::size_t{w[at]} + 1, spare), index);
}

/// True when a landmark lies wholly behind the first byte of the packet at `at`.
constexpr bool hides_landmark(const window& w, std::size_t at) noexcept {
    const std::size_t end = at + w[at] + 1;
    for (std::size_t q = next_candidate(w, at + 1); q + min_packet <= end; q = next_candidate(w, q + 1))
        if (is_intact(w, q, end) && is_landmark_at(w, q)) return true;
    return false;
}

/// While hunting, an intact packet is taken if it is a landmark, or if nothing inside it speaks for another phase.
constexpr bool is_convincing(const window& w, std::size_t at) noexcept { return is_landmark_at(w, at) || !hides_landmark(w, at); }
constexpr bool is_acceptable(const window& w, std::size_t at) noexcept { return is_intact(w, at, w.size()) && is_convincing(w, at); }

/// Looks for a short landmark from `probe` on, as far as the bytes go. True when one is found, at `probe`. A long
/// candidate that it lies in can then be given up at once instead of when its last byte has come.
constexpr bool find_short_landmark(const window& w, std::size_t& probe) noexcept {
    for (; (probe = next_candidate(w, probe)) < w.size(); ++probe) {
        const std::size_t left = w.size() - probe, size = std::size_t{w[probe]} + 1;
        if (size > longest_short) continue;
        const header h = judge_header(w, probe, std::min<std::size_t>(left, header_size + 1));
        if (h == header::unclear) return false;
        if (h != header::documented) continue;
        if (size > left || left <= header_size) return false;
        if (w.xor_of(probe, size) == 0 && is_landmark_at(w, probe)) return true;
    }
    return false;
}

/// True when the packet at `at`, of which six bytes or more have come, may yet turn out to be an error that agrees with
/// itself. Such a one is a landmark whatever lies inside, and must be waited for.
constexpr bool may_be_report(const window& w, std::size_t at) noexcept {
    constexpr std::size_t around = header_size + 3;  // code, expected_crc and the rejected packet's own LEN
    return w[at + 3] == command_of(common::error::key) && w[at + header_size + 1] + around == w[at];
}

/// What a search through the bytes at hand came to.
struct finding {
    std::size_t at = 0;   ///< The first byte that is still of interest: of the packet found, or of one still incomplete.
    bool found = false;   ///< A packet to accept lies at `at`, whole.
};

/// What is to be said of the place `at`, where a documented header may begin and no whole packet with a bad CRC: true
/// ends the search there. `probe` remembers how far the inside of a long candidate has been searched.
constexpr bool ends_hunt(const window& w, std::size_t at, std::size_t& probe, bool& found) noexcept {
    const std::size_t left = w.size() - at, size = std::size_t{w[at]} + 1;
    const header h = judge_header(w, at, std::min<std::size_t>(left, header_size + 1));
    if (h == header::unclear) return true;
    if (h != header::documented) return false;
    if (size <= left) return found = is_convincing(w, at);
    if (size <= longest_short) return true;
    probe = std::max(probe, at + 1);
    return !find_short_landmark(w, probe) || may_be_report(w, at);
}

/// The leftmost acceptable packet of `w`, or the leftmost place where one may yet be when more bytes come.
constexpr finding hunt(const window& w, std::size_t& probe) noexcept {
    bool ended = false, found = false;
    for (std::size_t at = 0; at < w.size(); ++at) {
        const auto run = w.run(at);
        rolling_xor sums(run);
        const auto wanted = [&](std::size_t place) {
            const std::size_t size = std::size_t{run[place]} + 1;
            const bool whole = size <= w.size() - at - place;
            if (whole && (size <= run.size() - place ? sums.over(place, size) : w.xor_of(at + place, size)) != 0) return false;
            return ended = ends_hunt(w, at + place, probe, found);
        };
        const std::size_t place = find_candidate(run, 0, wanted);
        if (!ended && place != run.size()) (void)wanted(place);  // of the last bytes in this piece nothing was said yet
        at += place;
        if (ended) return {at, found};
    }
    return {w.size(), false};
}

/// As `hunt` where no more bytes will come: packets that are cut off are passed over.
constexpr finding hunt_last(const window& w) noexcept {
    for (std::size_t at = next_candidate(w, 0); at < w.size(); at = next_candidate(w, at + 1))
        if (is_acceptable(w, at)) return {at, true};
    return {w.size(), false};
}

/// Where the packet begins that the end of the input cut off; `w.size()` if there is none. `fresh`: nothing was
/// skipped before these bytes, so that they may be a packet's first even when their header is not complete.
constexpr std::size_t find_cut(const window& w, bool fresh) noexcept {
    if (fresh && w.size() < header_size && judge_header(w, 0, w.size()) == header::unclear) return 0;
    for (std::size_t at = 0; at + header_size <= w.size(); ++at) {
        const std::size_t left = w.size() - at;
        const bool documented = judge_header(w, at, std::min<std::size_t>(left, header_size + 1)) == header::documented;
        if (documented && std::size_t{w[at]} + 1 > left) return at;
    }
    return w.size();
}

}  // namespace trama::daisy::recovery
