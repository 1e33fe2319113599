#pragma once
// The slow path of daisy/decoder.hpp, which includes this file.
#include "trama/daisy/decoder.hpp"

namespace trama::daisy {

namespace detail {
/// An event that `decoder::slow_next` goes on from.
constexpr event nothing() noexcept { event e{}; e.code = errc::ok; return e; }
}  // namespace detail

/// The slow path: everything but a landmark that lies whole in `in` while in step.
constexpr event decoder::slow_next(bytes_in& in) noexcept {
    begin_ += release_;
    release_ = 0;
    if (!hunting_ && !draining_ && !certain_ && phase_.settled())
        if (const auto whole = held() == 0 ? short_landmark(in) : joined_landmark(in); !whole.empty()) {
            quick_from_ = held() == release_ ? readable : never_quick;
            return deliver(whole, index_of(whole[1], whole[2], whole[3]));
        }
    quick_from_ = never_quick;
    for (;;) {
        bytes_in none{};
        auto& source = draining_ ? none : in;
        const event e = hunting_ ? hunt(source) : step(source);
        if (e.code != errc::ok || e.length != 0) {
            if (!hunting_ && !draining_ && !certain_ && held() == release_ && phase_.settled()) quick_from_ = readable;
            return e;
        }
    }
}

/// The fixed message at the front of `in`, nothing if none lies there whole: as the quick path, near a chunk's end.
constexpr decoder::bytes_in decoder::short_landmark(bytes_in& in) noexcept {
    if (in.size() < min_packet) return {};
    const std::size_t size = std::size_t{in[0]} + 1;
    const auto head = load_le<std::uint32_t>(in.data());
    if (!known.is_sized(known.find(head, in.data()), in.data()) || size < min_packet || size > in.size()) return {};
    const auto whole = in.first(size);
    if (xor_of(whole) != 0) return {};
    in = in.subspan(size);
    return whole;
}

/// The fixed message of which the stash holds the beginning and `in` the rest, nothing if there is none.
constexpr decoder::bytes_in decoder::joined_landmark(bytes_in& in) noexcept {
    const std::size_t had = held();
    if (had + in.size() < readable || begin_ + readable > stash_.size()) return {};
    const std::uint8_t* const front = stash_.data() + begin_;
    if (had < readable) copy_bytes(stash_.data() + end_, in.data(), readable - had);
    const auto low = load_le<std::uint64_t>(front);
    const std::size_t size = (low & 0xFF) + 1;
    if (!known.is_sized(known.find(static_cast<std::uint32_t>(low), front), front) || known.fold(low, front, low & 0xFF) != 0) return {};
    const std::size_t taken = size > had ? size - had : 0;
    end_ += taken;
    release_ = size;
    in = in.subspan(taken);
    return {front, size};
}

/// In step: judges the packet at the front.
constexpr event decoder::step(bytes_in& in) noexcept {
    const window w = bytes(in);
    if (w.size() == 0) return rest();
    if (judge_header(w, 0, std::min<std::size_t>(w.size(), header_size + 1)) == header::impossible) return fault(errc::bad_length, in);
    const std::size_t size = std::size_t{w[0]} + 1;
    if (w.size() < size) return draining_ ? fault(errc::truncated, in) : wait(in);
    if (w.xor_of(0, size) != 0) return fault(errc::bad_checksum, in);
    const auto whole = gather(size, in);
    const bool documented = judge_header(whole, 0, header_size + 1) == header::documented;
    const std::size_t index = index_of(whole[1], whole[2], whole[3]);
    const standing s = !documented ? standing::undocumented : recovery::is_landmark(whole, index) ? standing::landmark : standing::documented;
    if (certain_) {
        certain_ = false;
        phase_.begin(whole, s, std::exchange(resumed_, false), scratch_);
    } else if (const auto verdict = phase_.judge(whole, s, scratch_); !verdict.accepted) {
        promise_ = verdict;
        return fault(errc::noise, in);
    }
    if (held() != 0) release_ = size;
    else in = in.subspan(size);
    return index == unknown ? deliver_unknown(whole) : deliver(whole, index);
}

/// The packet at the front in one piece. Moves bytes of `in` to the stash if it begins there.
constexpr std::span<const std::uint8_t> decoder::gather(std::size_t size, bytes_in& in) noexcept {
    if (held() == 0) return in.first(size);
    if (held() < size) keep(size - held(), in);
    return {stash_.data() + begin_, size};
}

/// Nothing is at hand while in step.
constexpr event decoder::rest() noexcept {
    if (!draining_) return {};
    draining_ = certain_ = false;
    phase_.reset();
    return detail::nothing();
}

constexpr event decoder::wait(bytes_in& in) noexcept {
    keep(in.size(), in);
    return {};
}

/// Moves `n` bytes from `in` to the stash, where there is room for a packet.
constexpr void decoder::keep(std::size_t n, bytes_in& in) noexcept {
    if (end_ + n > stash_.size() || held() == 0) {
        for (std::size_t i = 0; i != held(); ++i) stash_[i] = stash_[begin_ + i];
        end_ = held();
        begin_ = 0;
    }
    copy_bytes(stash_.data() + end_, in.data(), n);
    end_ += n;
    in = in.subspan(n);
}

/// Out of step: the packet at the front is no packet.
constexpr event decoder::fault(errc code, bytes_in& in) noexcept {
    const window w = bytes(in);
    code_ = code;
    rejected_ = 0;
    if (code == errc::bad_checksum) {
        rejected_ = std::size_t{w[0]} + 1;
        for (std::size_t i = 0; i != rejected_; ++i) scratch_[i] = w[i];
    }
    phase_.reset();
    hunting_ = true;
    probe_ = 0;
    skip(1, in);
    return detail::nothing();
}

/// Consumes `n` bytes that no packet claims; the first ones are kept for the report.
constexpr void decoder::skip(std::size_t n, bytes_in& in) noexcept {
    const window w = bytes(in);
    for (std::size_t i = 0, at = static_cast<std::size_t>(std::min<std::uint64_t>(skipped_, scratch_.size())); i != n && at != scratch_.size();) scratch_[at++] = w[i++];
    skipped_ += n;
    probe_ -= std::min(probe_, n);
    const std::size_t here = std::min(n, held());
    begin_ += here;
    in = in.subspan(n - here);
}

constexpr event decoder::hunt(bytes_in& in) noexcept {
    const window w = bytes(in);
    if (promise_.resume != 0) {
        if (w.size() < promise_.resume && !draining_) return wait(in);
        resumed_ = w.size() >= promise_.resume && w.xor_of(0, promise_.resume) == promise_.sum;
        if (resumed_) skip(promise_.resume, in);
        promise_ = {};
        return detail::nothing();
    }
    const recovery::finding f = draining_ ? recovery::hunt_last(w) : recovery::hunt(w, probe_);
    if (!f.found && draining_) return drain(in);
    skip(f.at, in);
    resumed_ = resumed_ && f.at == 0;
    if (!f.found) return wait(in);
    hunting_ = false;
    certain_ = true;
    return skipped_ != 0 ? report() : detail::nothing();
}

/// The input ended while hunting and no packet is left.
constexpr event decoder::drain(bytes_in& in) noexcept {
    const window w = bytes(in);
    const std::size_t cut = code_ == errc::truncated ? w.size() : recovery::find_cut(w, code_ == errc::noise && skipped_ == 0);
    skip(cut, in);
    if (skipped_ != 0 && cut != w.size()) {
        const event e = report();
        code_ = errc::truncated;
        return e;
    }
    if (cut != w.size()) {
        code_ = errc::truncated;
        skip(w.size() - cut, in);
    }
    hunting_ = resumed_ = false;
    return skipped_ != 0 ? report() : detail::nothing();
}

/// The event of a loss of step.
constexpr event decoder::report() noexcept {
    event e{};
    e.code = code_;
    e.offset = offset_;
    e.length = skipped_;
    e.bytes = {scratch_.data(), static_cast<std::size_t>(std::min<std::uint64_t>(skipped_, scratch_.size()))};
    if (code_ == errc::bad_checksum) {
        e.rejected = {scratch_.data(), rejected_};
        e.received = scratch_[rejected_ - 1];
        e.expected = checksum(e.rejected.first(rejected_ - 1));
    }
    ++counters_.errors[static_cast<std::size_t>(code_)];
    counters_.skipped += skipped_;
    offset_ += skipped_;
    skipped_ = 0;
    return e;
}

}  // namespace trama::daisy
