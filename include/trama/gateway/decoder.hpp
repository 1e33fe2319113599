#pragma once

#include "trama/gateway/record.hpp"

namespace trama::gateway {

/// What `decoder::next` reports. Views live until the decoder's next call, and no longer than the chunk given to it. The only `bad_number` that a decoder
/// reports is that of the record's own type; those of other fields come from `decode` and `visit`.
using event = basic_event<packet>;

/// Cuts a TCP stream into records. [gateway, "Tipos de mensajes"]
///
/// STX always begins a record, so that no fault costs an intact one. A run of bytes outside a record is one `noise`;
/// a record that a STX or the end of the input cuts off is `truncated`; one with a control or non-ASCII byte is
/// `bad_character`, one of more than 206 characters `bad_length`, up to the next ETX or STX.
class decoder {
public:
    /// Takes bytes from the front of `in` and reports one record or error, or `need_more` with `in` empty.
    /// A record lying whole in `in` is viewed in place, one that straddles chunks in the decoder's own memory.
    [[gnu::always_inline]] constexpr event next(std::span<const std::uint8_t>& in) noexcept {
        if (length_ == 0 && in.size() > type_size + 1) [[likely]] {
            const auto key = start_of(in.data());
            const catalogue::start& s = known.find(key);
            const std::size_t payload = s.payload;
            if (s.key == key && in.size() > payload + 1 && in[payload + 1] == etx && all_printable(in.data() + 1, payload)) [[likely]] {
                const auto whole = in.first(payload + 2);
                in = in.subspan(payload + 2);
                return deliver(whole, s.type, s.index);
            }
        }
        auto slow = advance(in);  // not const: g++ 12 keeps const objects of this size in memory, on the quick path too
        in = slow.rest;
        return slow.event;
    }

    /// The input ends here: a partial record is `truncated`. Call `next` until it needs more.
    constexpr void finish() noexcept { draining_ = length_ != 0; }
    /// As a new decoder at offset 0; only the counters stay.
    constexpr void reset() noexcept {
        const trama::counters kept = counters_;
        *this = decoder{};
        counters_ = kept;
    }
    /// Bytes consumed and not yet reported.
    constexpr std::uint64_t pending() const noexcept { return length_; }
    constexpr const trama::counters& counters() const noexcept { return counters_; }
    /// Offset of the first byte not yet reported.
    constexpr std::uint64_t offset() const noexcept { return offset_; }
    /// The offset of the next byte, for callers that begin inside a stream.
    constexpr void seek(std::uint64_t offset) noexcept { offset_ = offset - pending(); }

private:
    using bytes_in = std::span<const std::uint8_t>;

    constexpr event deliver(bytes_in whole, std::uint32_t type, std::size_t index) noexcept {
        event e{};
        e.code = errc::ok;
        e.packet = packet(whole, type, index);
        e.offset = offset_;
        e.length = whole.size();
        ++counters_.packets;
        offset_ += whole.size();
        return e;
    }

    [[gnu::noinline]] constexpr stepped<event, std::uint8_t> advance(bytes_in in) noexcept { return {in, [this](auto& rest) { return slow_next(rest); }}; }
    /// Everything but an intact record that lies whole in `in`.
    constexpr event slow_next(bytes_in& in) noexcept {
        if (draining_) {
            draining_ = false;
            return end(interrupted(), {});
        }
        const bool fresh = length_ == 0;
        if (in.empty()) return {};
        if (fresh) { in_record_ = in[0] == stx; foreign_character_ = false; }
        std::size_t used = fresh ? 1 : 0;
        bool complete = false;
        errc code = errc::noise;
        if (in_record_) code = scan_record(in, used, complete);
        else complete = scan_noise(in, used);
        const auto taken = in.first(used);
        in = in.subspan(used);
        if (fresh && complete) {
            length_ = used;
            return end(code, taken);
        }
        keep(taken);
        return complete ? end(code, {}) : event{};
    }
    /// Runs to the next STX.
    static constexpr bool scan_noise(bytes_in in, std::size_t& used) noexcept {
        while (used != in.size() && in[used] != stx) ++used;
        return used != in.size();
    }
    /// Runs to the record's end: behind ETX, before STX. The code is `ok` when an ETX ended printable content.
    constexpr errc scan_record(bytes_in in, std::size_t& used, bool& complete) noexcept {
        if (!foreign_character_) used += printable_run(in.data() + used, in.size() - used);
        const auto is_delimiter = [](std::uint8_t c) { return c == stx || c == etx; };
        while (used != in.size() && !is_delimiter(in[used])) {
            foreign_character_ = true;
            ++used;
        }
        if (used == in.size()) return errc::ok;
        complete = true;
        const bool closed = in[used] == etx;
        const std::uint64_t characters = length_ + used - 1;
        if (closed) ++used;
        if (foreign_character_) return errc::bad_character;
        if (characters > max_payload) return errc::bad_length;
        return closed ? errc::ok : errc::truncated;
    }
    /// Why an unfinished piece of input is no record.
    constexpr errc interrupted() const noexcept {
        if (!in_record_) return errc::noise;
        if (foreign_character_) return errc::bad_character;
        return length_ - 1 > max_payload ? errc::bad_length : errc::truncated;
    }
    constexpr std::size_t in_stash() const noexcept { return static_cast<std::size_t>(std::min<std::uint64_t>(length_, stash_.size())); }
    constexpr void keep(bytes_in taken) noexcept {
        const std::size_t kept = in_stash();
        copy_bytes(stash_.data() + kept, taken.data(), std::min(taken.size(), stash_.size() - kept));
        length_ += taken.size();
    }
    /// Ends the piece of input at hand, which `in_place` holds unless it is in the stash.
    constexpr event end(errc code, bytes_in in_place) noexcept {
        const bytes_in all = in_place.empty() ? bytes_in{stash_.data(), in_stash()} : in_place.first(std::min(in_place.size(), stash_.size()));
        const std::uint64_t length = length_;
        length_ = 0;
        std::uint32_t type = 0;
        std::size_t index = unknown;
        if (code == errc::ok) code = judge(all, type, index);
        if (code == errc::ok) return deliver(all, type, index);
        event e{};
        e.code = code;
        if (code == errc::unknown_message) e.packet = packet(all, type, index);
        e.offset = offset_;
        e.length = length;
        e.bytes = all;
        ++counters_.errors[static_cast<std::size_t>(code)];
        if (code != errc::unknown_message) counters_.skipped += length;
        offset_ += length;
        return e;
    }
    /// What a record with printable content is. [gateway, "Tipos de mensajes"]
    static constexpr errc judge(bytes_in whole, std::uint32_t& type, std::size_t& index) noexcept {
        if (whole.size() < type_size + 2) return errc::bad_length;
        const std::uint64_t bad = read_columns<type_size>(whole.data() + 1, type);
        const bool blank = whole[1] == ' ' && whole[2] == ' ' && whole[3] == ' ';
        if (bad != 0 || blank) return errc::bad_number;
        index = index_of(type);
        if (index == unknown) return errc::unknown_message;
        return whole.size() == known.payload[index] + std::size_t{2} ? errc::ok : errc::bad_length;
    }

    bool draining_ = false;
    bool in_record_ = false;          ///< The piece of input at hand began with STX.
    bool foreign_character_ = false;  ///< The record holds a control or non-ASCII byte.
    std::uint64_t length_ = 0;        ///< Bytes of the piece of input at hand, which no event has covered yet.
    std::uint64_t offset_ = 0;
    trama::counters counters_{};
    std::array<std::uint8_t, 256> stash_{};  ///< The first of them.
};

}  // namespace trama::gateway
