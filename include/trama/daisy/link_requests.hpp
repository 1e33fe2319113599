#pragma once

#include "trama/daisy/link.hpp"

namespace trama::daisy {

namespace detail {
template <daisy::key Key, class... All>
struct with_key { using type = void; };
template <daisy::key Key, class First, class... Rest>
struct with_key<Key, First, Rest...> : std::conditional_t<First::key == Key, std::type_identity<First>, with_key<Key, Rest...>> {};
template <daisy::key Key, class List>
struct in_list;
template <daisy::key Key, class... All>
struct in_list<Key, message_list<All...>> : with_key<Key, All...> {};
}  // namespace detail

/// The response to request `M`; void for `error` and for responses. `reply_of<dc_motor::get_encoder>` is `get_encoder_reply`.
template <class M>
using reply_of = typename detail::in_list<key_of(family_of(M::key), command_of(M::key) | response_bit), messages>::type;

/// A request of the document: something that is answered.
template <class M>
concept request_message = messages::contains<M> && (command_of(M::key) & response_bit) == 0 && !std::is_void_v<reply_of<M>>;

/// Whether what is sent to `to` is for the board `one`.
constexpr bool reaches(address to, address one) noexcept { return to == one || to == everyone || (to.broadcast() && to.group() == one.group()); }

inline constexpr std::size_t max_request = 16;  ///< No request of the document is longer.

/// A request that has been sent and waits for its reply.
struct request_in_flight {
    enum class state : std::uint8_t { free, waiting, settling };

    state now = state::free;
    std::uint8_t size = 0;
    std::uint8_t expected = 0;   ///< Of a call to everyone: how many boards the list has to hold at its end.
    bool home = false;           ///< Of a broadcast: it has gone round.
    unsigned attempts = 0;       ///< How often it was sent.
    unsigned allowed = 0;        ///< How often it may be sent in all.
    std::uint64_t first = 0;     ///< When it was sent first.
    std::uint64_t latest = 0;    ///< When it was sent last, or settled.
    std::uint64_t answered = 0;  ///< Of a broadcast: bit n, the n-th board has answered.
    std::uint64_t refused = 0;   ///< Likewise by an `error`; of a request to one board any bit.
    std::array<std::uint8_t, max_request> octets{};

    constexpr std::span<const std::uint8_t> packet() const noexcept { return {octets.data(), size}; }
    constexpr address destination() const noexcept { return {octets[1]}; }
    constexpr std::uint8_t command() const noexcept { return octets[3]; }
    /// True when a packet of `source` with the response bit set in `command` is what it waits for.
    constexpr bool expects(address source, std::uint8_t reply_command) const noexcept {
        return reply_command == (command() | response_bit) && reaches(destination(), source);
    }
    /// True when one reply could be taken for that to this and for that to another request.
    constexpr bool overlaps(address to, std::uint8_t other_command) const noexcept {
        return command() == other_command && (reaches(destination(), to) || reaches(to, destination()));
    }
};

/// Requests in flight, told apart by peer and command, all that a reply says: no two are in the table that one reply
/// could answer.
///
/// A reply may also come late: a request that was sent more than once may get more than one, and one that was given up
/// may get one still. The place of such a request therefore stays taken, it settles, for one time-out after the end, so
/// that a late reply is never taken for the reply to the next request.
template <std::size_t Size>
class request_table {
public:
    constexpr explicit request_table(const timing& t) noexcept : timing_(t) {}

    /// A free place; null when there is none, or one in flight or settling could get the same reply.
    constexpr request_in_flight* place_for(address to, std::uint8_t command, std::uint64_t now) noexcept {
        request_in_flight* place = nullptr;
        for (request_in_flight& r : requests_) {
            release(r, now);
            if (r.now == request_in_flight::state::free) place = &r;
            else if (r.overlaps(to, command)) return nullptr;
        }
        return place;
    }
    /// Notes `packet`, at most `max_request` bytes, as sent, in a `place_for` it. `attempts` 0: as many as `timing` says.
    constexpr void add(request_in_flight& place, std::span<const std::uint8_t> packet, std::uint64_t now, unsigned attempts) const noexcept {
        const unsigned allowed = attempts != 0 ? attempts : timing_.attempts;
        place = {};
        place.now = request_in_flight::state::waiting;
        place.size = static_cast<std::uint8_t>(packet.size());
        place.attempts = 1;
        place.allowed = allowed;
        place.first = place.latest = now;
        copy_bytes(place.octets.data(), packet.data(), packet.size());
    }

    /// The request that a reply belongs to, null when none waits for it.
    constexpr request_in_flight* find(address source, std::uint8_t reply_command) noexcept {
        for (request_in_flight& r : requests_)
            if (is_waiting(r) && r.expects(source, reply_command)) return &r;
        return nullptr;
    }
    /// The oldest request that waits for `peer`, by any command: `error` does not say which one it is about.
    /// One to a single board comes before a broadcast. A broadcast that `peer`, whose bit in `answered` is `bit`, has answered can be
    /// meant only if it was sent more than once and `peer` refused it.
    constexpr request_in_flight* oldest_to(address peer, std::uint64_t bit) noexcept {
        request_in_flight* oldest = nullptr;
        for (request_in_flight& r : requests_) {
            const auto reply = static_cast<std::uint8_t>(r.command() | response_bit);
            if (!is_waiting(r) || !r.expects(peer, reply) || ((r.answered & bit) != 0 && (r.attempts == 1 || (r.refused & bit) == 0))) continue;
            const bool nearer = oldest != nullptr && oldest->destination().broadcast() && !r.destination().broadcast();
            const bool wider = oldest != nullptr && !oldest->destination().broadcast() && r.destination().broadcast();
            if (oldest == nullptr || nearer || (!wider && r.first < oldest->first)) oldest = &r;
        }
        return oldest;
    }
    /// True when a refusal of `peer` is the second one of a request that is over: what was sent more than once may be refused
    /// again. Counts as that one time.
    constexpr bool refused_before(address peer, std::uint64_t bit, std::uint64_t now) noexcept {
        for (request_in_flight& r : requests_) {
            release(r, now);
            const std::uint64_t its = r.destination().broadcast() ? bit : ~std::uint64_t{0};
            if (r.now != request_in_flight::state::settling || (r.refused & its) == 0 || r.attempts == 1 || !reaches(r.destination(), peer)) continue;
            r.refused &= ~its;
            return true;
        }
        return false;
    }
    /// The request that came back whole, or null.
    constexpr request_in_flight* same_as(std::span<const std::uint8_t> packet) noexcept {
        for (request_in_flight& r : requests_)
            if (is_waiting(r) && r.size == packet.size() && differing(r.packet(), packet) == 0) return &r;
        return nullptr;
    }
    /// The request that somebody received as `rejected`, the nearest one; null when none resembles it.
    constexpr request_in_flight* nearest(std::span<const std::uint8_t> rejected) noexcept {
        request_in_flight* best = nullptr;
        for (request_in_flight& r : requests_) {
            if (!is_waiting(r) || !resembles(r.packet(), rejected)) continue;
            if (best == nullptr || differing(r.packet(), rejected) < differing(best->packet(), rejected)) best = &r;
        }
        return best;
    }
    /// A request whose time is up, the one first sent first; null when there is none.
    constexpr request_in_flight* overdue(std::uint64_t now) noexcept {
        request_in_flight* found = nullptr;
        for (request_in_flight& r : requests_) {
            const bool late = is_waiting(r) && elapsed(r.latest, now) > timing_.timeout;
            if (late && (found == nullptr || r.first < found->first)) found = &r;
        }
        return found;
    }

    static constexpr bool may_repeat(const request_in_flight& r) noexcept { return r.attempts < r.allowed; }
    /// It was sent once more.
    static constexpr void repeated(request_in_flight& r, std::uint64_t now) noexcept {
        ++r.attempts;
        r.latest = now;
    }
    /// It is answered, or nobody can answer it. Nothing more can come if it was sent but once.
    static constexpr void finish(request_in_flight& r, std::uint64_t now) noexcept {
        r.now = r.attempts > 1 ? request_in_flight::state::settling : request_in_flight::state::free;
        r.latest = now;
    }
    /// It is given up. A reply may come all the same.
    static constexpr void give_up(request_in_flight& r, std::uint64_t now) noexcept {
        r.now = request_in_flight::state::settling;
        r.latest = now;
    }
    /// The list of boards that `answered` refers to is a new one. A broadcast that was home has to come home once more.
    constexpr void forget_answers() noexcept {
        for (request_in_flight& r : requests_) {
            r.answered = 0;
            if (r.destination().broadcast()) r.refused = 0;
            r.home = false;
        }
    }
    /// The first that waits for a reply and of which `f(r)` holds; null when there is none.
    constexpr request_in_flight* waiting_one(auto&& f) noexcept {
        for (request_in_flight& r : requests_)
            if (is_waiting(r) && f(r)) return &r;
        return nullptr;
    }
    /// Requests that wait for a reply.
    constexpr std::size_t waiting() const noexcept {
        std::size_t n = 0;
        for (const request_in_flight& r : requests_) n += is_waiting(r) ? 1U : 0U;
        return n;
    }

private:
    static constexpr bool is_waiting(const request_in_flight& r) noexcept { return r.now == request_in_flight::state::waiting; }
    constexpr void release(request_in_flight& r, std::uint64_t now) const noexcept {
        const bool over = elapsed(r.latest, now) > timing_.timeout;
        if (r.now == request_in_flight::state::settling && over) r.now = request_in_flight::state::free;
    }

    timing timing_;
    std::array<request_in_flight, Size> requests_{};
};

}  // namespace trama::daisy
