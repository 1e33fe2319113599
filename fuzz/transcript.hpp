#pragma once
// What a decoder reported, without views, and the checks that hold at every single call.
#include <algorithm>
#include <string_view>

#include "traits.hpp"
#include "trama/core/wire_format.hpp"

namespace trama::fuzz {

/// One event, its bytes copied.
template <wire_format F>
struct record {
    errc code{};
    std::uint64_t offset = 0, length = 0;
    std::size_t index = 0;
    octets body, bytes, extra;
    typename F::envelope envelope{};  ///< Of a packet.
    std::uint32_t id = 0;             ///< Of can's frames, in errors too.

    bool is_packet() const { return code == errc::ok || code == errc::unknown_message; }
    friend bool operator==(const record&, const record&) = default;
};

/// True when `view` lies inside `memory`; empty views lie anywhere.
inline bool lies_in(std::span<const std::uint8_t> view, const void* memory, std::size_t size) {
    const auto* begin = static_cast<const std::uint8_t*>(memory);
    return view.empty() || (begin <= view.data() && view.data() + view.size() <= begin + size);
}

template <wire_format F>
class listener {
public:
    using unit = typename F::unit;
    using event = decltype(std::declval<typename F::decoder&>().next(std::declval<std::span<const unit>&>()));

    /// Feeds one chunk, from a heap block of exactly its size.
    void feed(std::span<const unit> chunk) {
        const exact<unit> copy(chunk);
        fed_ += chunk.size();
        std::span<const unit> in = copy.all();
        drain(in, copy.all());
    }
    void finish() {
        decoder_.finish();
        std::span<const unit> none;
        drain(none, none);
        require(decoder_.pending() == 0, "nothing is pending after the end of the input");
    }
    /// The line fell silent, where the format has such a thing.
    void idle() {
        if constexpr (requires { decoder_.idle(); }) {
            decoder_.idle();
            std::span<const unit> none;
            drain(none, none);
            require(decoder_.pending() == 0, "nothing is pending after idle()");
        }
    }
    /// Time goes on to `now`, where the decoder is told.
    void tick(std::uint64_t now) {
        if constexpr (requires { decoder_.tick(now); }) {
            decoder_.tick(now);
            std::span<const unit> none;
            drain(none, none);
        }
    }
    std::vector<record<F>> records() && { return std::move(records_); }
    typename F::decoder& decoder() { return decoder_; }

private:
    void drain(std::span<const unit>& in, std::span<const unit> chunk) {
        const std::uint64_t before = fed_ - chunk.size();
        for (std::size_t calls = 2 * chunk.size() + 2 * F::max_units + 8;; --calls) {
            require(calls != 0, "next() makes progress");
            const auto e = decoder_.next(in);
            if (e.code == errc::need_more) break;
            note(e, chunk);
            check_balance(before + (chunk.size() - in.size()));
        }
        require(in.empty(), "need_more means that the chunk is used up");
        check_balance(fed_);
    }
    void note(const event& e, std::span<const unit> chunk) {
        require(e.code != errc::out_of_range && e.code != errc::buffer_too_small, "a decoder reports decoding errors only");
        require(e.length != 0, "an event covers something");
        require(lies_somewhere(e.bytes, chunk), "the bytes of an event lie in the chunk or in the decoder");
        record<F> r{e.code, e.offset, e.length, e.packet.index(), {}, {e.bytes.begin(), e.bytes.end()}, {}};
        if constexpr (requires { e.id; }) r.id = e.id;
        if (r.is_packet()) {
            const auto body = e.packet.body();
            require(lies_somewhere(body, chunk), "a packet lies in the chunk or in the decoder");
            require((e.code == errc::ok) == (r.index < F::messages::count), "exactly the packets of known messages are ok");
            r.body.assign(body.begin(), body.end());
            r.envelope = e.packet.envelope();
            ++packets_[e.code == errc::ok];
        }
        if (e.code != errc::ok) {
            ++errors_[static_cast<std::size_t>(e.code)];
            if (e.code != errc::unknown_message) skipped_ += e.length;
        }
        if constexpr (requires { e.rejected; }) {
            require(lies_somewhere(e.rejected, chunk), "the rejected packet lies in the chunk or in the decoder");
            r.extra.assign(e.rejected.begin(), e.rejected.end());
            r.extra.push_back(e.expected);
            r.extra.push_back(e.received);
        }
        reported_ += e.length;
        records_.push_back(std::move(r));
    }
    bool lies_somewhere(std::span<const std::uint8_t> view, std::span<const unit> chunk) const {
        return lies_in(view, chunk.data(), chunk.size_bytes()) || lies_in(view, &decoder_, sizeof decoder_);
    }
    /// Every unit belongs to exactly one event, is pending, or is foreign; the counters tell the same as the events.
    void check_balance(std::uint64_t consumed) {
        const counters& c = decoder_.counters();
        require(reported_ + decoder_.pending() + c.foreign == consumed, "no unit disappears: events, pending and foreign add up");
        require(c.packets == packets_[1], "the counter of packets is the number of packets");
        require(c.skipped == skipped_, "the counter of skipped units is the sum of the errors' lengths");
        require(std::equal(errors_.begin(), errors_.end(), c.errors.begin()), "the counters of errors are the number of errors");
    }

    typename F::decoder decoder_{};
    std::vector<record<F>> records_;
    std::uint64_t fed_ = 0, reported_ = 0, skipped_ = 0;
    std::array<std::uint64_t, 2> packets_{};
    std::array<std::uint64_t, errc_count> errors_{};
};

/// Everything that a new decoder says about `units`, cut by `chunk_size()`.
template <wire_format F>
std::vector<record<F>> transcript(std::span<const typename F::unit> units, auto chunk_size) {
    listener<F> l;
    while (!units.empty()) {
        const auto chunk = units.first(std::min<std::size_t>(units.size(), chunk_size()));
        units = units.subspan(chunk.size());
        l.feed(chunk);
    }
    l.finish();
    return std::move(l).records();
}
template <wire_format F>
std::vector<record<F>> transcript(std::span<const typename F::unit> units) {
    return transcript<F>(units, [&] { return units.size(); });
}

}  // namespace trama::fuzz
