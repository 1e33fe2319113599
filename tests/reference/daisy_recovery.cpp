#include "daisy_recovery.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "daisy_table.hpp"

namespace trama_reference {

namespace {

// What the bytes of a stream look like, apart from any decoder. Positions are offsets in the
// stream; `end` is always one past the last byte that may be looked at.
class sight {
 public:
  explicit sight(std::span<const std::uint8_t> stream) : bytes_(stream), xor_before_(stream.size() + 1) {
    for (std::size_t i = 0; i < stream.size(); ++i) {
      xor_before_[i + 1] = static_cast<std::uint8_t>(xor_before_[i] ^ stream[i]);
    }
  }

  std::uint8_t at(std::size_t q) const { return bytes_[q]; }

  /// One past the packet's end. LEN must be there.
  std::size_t packet_end(std::size_t q) const { return q + at(q) + 1U; }

  std::uint8_t xor_over(std::size_t from, std::size_t to) const {
    return static_cast<std::uint8_t>(xor_before_[from] ^ xor_before_[to]);
  }

  /// The message of the 4 header bytes at q, which must be there.
  const message_form* message(std::size_t q) const { return find_message(at(q + 1), at(q + 2), at(q + 3)); }

  /// The first DATA byte, if there is one in the packet and it has come.
  std::optional<std::uint8_t> first_data(std::size_t q, std::size_t end) const {
    if (at(q) < 5 || q + 5 > end) return std::nullopt;
    return at(q + 4);
  }

  /// A defined command, whatever the addresses, with a LEN that it cannot have.
  bool impossible_length(std::size_t q, std::size_t end) const {
    const message_form* found = message(q);
    return found != nullptr && !length_possible(*found, at(q), first_data(q, end));
  }

  enum class header { impossible, possible, documented };

  /// `possible`: fewer than 4 bytes are there, and nothing speaks against them.
  header documented_header(std::size_t q, std::size_t end) const {
    const std::size_t there = end - q;
    if (there >= 1 && at(q) < 4) return header::impossible;
    if (there >= 2 && (at(q + 1) >> 4) > 6 && at(q + 1) != 0xFF) return header::impossible;
    if (there >= 3 && (at(q + 2) >> 4) > 6) return header::impossible;
    if (there < 4) return header::possible;
    if (!documented_addresses(at(q + 1), at(q + 2), at(q + 3))) return header::impossible;
    if (message(q) == nullptr || impossible_length(q, end)) return header::impossible;
    return header::documented;
  }

  bool complete(std::size_t q, std::size_t end) const { return q < end && packet_end(q) <= end; }

  /// A documented header on a whole packet with a good CRC.
  bool documented_packet(std::size_t q, std::size_t end) const {
    return complete(q, end) && documented_header(q, end) == header::documented &&
           xor_over(q, packet_end(q)) == 0;
  }

  bool landmark(std::size_t q, std::size_t end) const {
    if (!documented_packet(q, end)) return false;
    const message_form& found = *message(q);
    if (found.form == shape::text) return plain_text(q) && !holds_short_packet(q);
    if (found.form == shape::error && at(q + 4) == 0) return consistent_error(q);
    return true;
  }

  bool acceptable_while_hunting(std::size_t q, std::size_t end) const {
    if (!documented_packet(q, end)) return false;
    if (landmark(q, end)) return true;
    for (std::size_t inner = q + 1; inner < packet_end(q); ++inner) {
      if (landmark(inner, packet_end(q))) return false;
    }
    return true;
  }

  // The packet at q has not come whole. If it holds a whole landmark of at most 22 bytes, nobody waits for it, unless it
  // may become an error whose rejected packet has the right length. A landmark that may yet come whole is waited for.
  // Packets for which `accepted` holds do not count.
  bool worth_waiting_for(std::size_t q, std::size_t end, auto&& accepted) const {
    constexpr std::size_t longest_short = 22;
    for (std::size_t inner = q + 1; inner < end; ++inner) {
      const header begun = documented_header(inner, end);
      if (begun == header::possible) return true;
      if (begun == header::impossible || packet_end(inner) - inner > longest_short) continue;
      if (!complete(inner, end)) return true;
      if (!accepted(inner) && landmark(inner, end)) return at(q + 3) == 0x04 && q + 5 < end && at(q + 5) + 7U == at(q);
    }
    return true;
  }

 private:
  bool plain_text(std::size_t q) const {
    for (std::size_t i = q + 4; i + 1 < packet_end(q); ++i) {
      const std::uint8_t byte = at(i);
      const bool plain = (byte >= 0x20 && byte <= 0x7E) || byte == '\t' || byte == '\r' || byte == '\n';
      if (!plain) return false;
    }
    return true;
  }

  // A whole packet that can hold nothing but numbers lies behind the text's first byte.
  bool holds_short_packet(std::size_t q) const {
    const std::size_t end = packet_end(q);
    for (std::size_t inner = q + 1; inner < end; ++inner) {
      if (!documented_packet(inner, end)) continue;
      const shape form = message(inner)->form;
      if (form != shape::text && form != shape::error) return true;
    }
    return false;
  }

  // LEN destination source 0x04 | 0x00 rejected… expected_crc | CRC
  bool consistent_error(std::size_t q) const {
    const std::size_t first = q + 5;
    const std::size_t expected_crc = packet_end(q) - 2;
    const std::size_t size = expected_crc - first;
    return at(first) + 1U == size && at(expected_crc) == xor_over(first, expected_crc - 1);
  }

  std::span<const std::uint8_t> bytes_;
  std::vector<std::uint8_t> xor_before_;
};

// One stretch of the stream, from a start or an idle() to the next idle() or the end.
class stretch {
 public:
  stretch(const sight& seen, std::size_t begin, std::size_t end, std::vector<daisy_event>& events)
      : seen_(seen), p_(begin), end_(end), events_(events) {}

  /// As at the start and after reset(): hunting, code noise, from the first byte.
  void run_hunting() {
    hunt({p_, 0, "noise"}, p_);
    run_in_step();
  }

  void run_in_step() {
    while (p_ < end_) judge();
  }

 private:
  // In step at p_: accepts the packet there or loses step.
  void judge() {
    if (seen_.at(p_) < 4) return lose_step("bad_length");
    if (end_ - p_ >= 4 && seen_.impossible_length(p_, end_)) return lose_step("bad_length");
    if (!seen_.complete(p_, end_)) return lose_step("truncated");
    if (seen_.xor_over(p_, seen_.packet_end(p_)) != 0) return lose_step("bad_checksum");
    const rank judged = rank_of_packet();
    if (!hunter_active_ && judged != rank::landmark) {
      watch_from(p_ + 1);
      trust_ = vouched_ ? most_trust : 0;
    }
    bool found = false;
    if (hunter_active_) found = shadow_finds(judged);
    if (judged == rank::undocumented && (found || doubted_ || (chain_ > 0 && s_ < p_))) return lose_step_to_the_chain();
    if (judged == rank::documented && found && !vouched_ && trust_ <= chain_) return lose_step_to_the_chain();
    doubted_ = judged == rank::documented && found;
    vouched_ = judged == rank::landmark;
    trust_ = judged == rank::undocumented ? 0 : trusted(trust_ + seen_.packet_end(p_) - p_);
    accept();
  }

  // How much a packet says about the phase it was found in.
  enum class rank { undocumented, documented, landmark };

  // More does not count, of trust in this phase and of the other one's chain.
  static constexpr std::size_t most_trust = 768;
  static std::size_t trusted(std::size_t bytes) { return std::min(bytes, most_trust); }

  rank rank_of_packet() const {
    if (seen_.landmark(p_, end_)) return rank::landmark;
    return seen_.documented_packet(p_, end_) ? rank::documented : rank::undocumented;
  }

  void watch_from(std::size_t place) {
    hunter_active_ = true;
    chain_ = 0;
    s_ = place;
  }

  void accept() {
    const std::size_t after = seen_.packet_end(p_);
    events_.push_back({p_, after - p_});
    accepted_.insert(p_);
    p_ = after;
  }

  // The shadow hunter works on all bytes up to the end of the packet at p_; tells whether it found any.
  bool shadow_finds(rank judged) {
    const std::size_t seen_end = seen_.packet_end(p_);
    const auto accepted = [&](std::size_t q) { return q == p_ || accepted_.contains(q); };
    bool found = false;
    while (s_ < seen_end) {
      if (s_ == p_ && judged == rank::landmark && vouched_) {
        hunter_active_ = false;  // two landmarks in a row, and nothing begins in the first one
        return found;
      }
      const sight::header header = seen_.documented_header(s_, seen_end);
      if (header == sight::header::possible) return found;  // waits for more bytes
      const bool begun = header == sight::header::documented && !seen_.complete(s_, seen_end);
      if (begun && seen_.worth_waiting_for(s_, seen_end, accepted)) return found;
      if (accepted(s_) || !seen_.acceptable_while_hunting(s_, seen_end)) {
        chain_ = 0;
        ++s_;
        continue;
      }
      if (judged == rank::undocumented || seen_.landmark(s_, seen_end)) found = true;
      link_ = s_;
      s_ = seen_.packet_end(s_);
      chain_ = trusted(chain_ + s_ - link_);
    }
    return found;
  }

  // Refuses the packet at p_. If packets of the shadow's chain reach over its start, they are those to go on with: no
  // packet of theirs that has begun can still be had, so the hunt begins behind the one that reaches over p_.
  void lose_step_to_the_chain() {
    const std::size_t over = s_ > p_ ? link_ : s_;
    if (chain_ > 0 && over < p_ && seen_.documented_packet(over, end_) && seen_.packet_end(over) > p_ + 1) {
      hunt({p_, 0, "noise"}, seen_.packet_end(over), most_trust);
    } else {
      lose_step("noise");
    }
  }

  void lose_step(const std::string& code) {
    daisy_event loss = {p_, 0, code};
    if (code == "bad_checksum") {
      const std::size_t crc = seen_.packet_end(p_) - 1;
      loss.expected = seen_.xor_over(p_, crc);
      loss.received = seen_.at(crc);
    }
    hunt(loss, p_ + 1);
  }

  // Ends in step behind the leftmost acceptable packet, or at the end of the stretch.
  // `trust`: in the packet that begins at `from`, if there is one.
  void hunt(daisy_event loss, std::size_t from, std::size_t trust = 0) {
    hunter_active_ = false;
    vouched_ = false;
    doubted_ = false;
    std::size_t q = from;
    while (q < end_ && !seen_.acceptable_while_hunting(q, end_)) ++q;
    if (q >= end_) return report_rest(loss, from);
    report(loss, q);
    p_ = q;
    vouched_ = seen_.landmark(q, end_);
    trust_ = trusted((q == from ? trust : 0) + seen_.packet_end(q) - q);
    watch_from(q + 1);
    accept();
  }

  // Nothing acceptable is left from `from` on: says whether a packet was cut off by the end.
  void report_rest(const daisy_event& loss, std::size_t from) {
    p_ = end_;
    const std::optional<std::size_t> cut = cut_off_packet(loss, from);
    if (loss.error == "truncated" || !cut) return report(loss, end_);
    report(loss, *cut);
    report({*cut, 0, "truncated"}, end_);
  }

  std::optional<std::size_t> cut_off_packet(const daisy_event& loss, std::size_t from) const {
    for (std::size_t c = from; c < end_; ++c) {
      const sight::header header = seen_.documented_header(c, end_);
      if (header == sight::header::documented && !seen_.complete(c, end_)) return c;
      const bool noise_from_here = loss.error == "noise" && c == loss.offset;
      if (noise_from_here && header == sight::header::possible) return c;
    }
    return std::nullopt;
  }

  // An event of length 0 is not reported.
  void report(daisy_event event, std::size_t to) {
    event.length = to - event.offset;
    if (event.length > 0) events_.push_back(event);
  }

  const sight& seen_;
  std::size_t p_;
  std::size_t end_;
  std::vector<daisy_event>& events_;
  bool vouched_ = false;  // the packet accepted last was a landmark
  bool doubted_ = false;  // the packet accepted last was believed for the landmark before it only
  std::size_t trust_ = 0;  // bytes of documented packets accepted in a row, while the shadow hunter works
  bool hunter_active_ = false;
  std::size_t s_ = 0;
  std::size_t chain_ = 0;  // bytes of the packets in a row, of another phase, that end at s_
  std::size_t link_ = 0;   // where the last one begins
  std::set<std::size_t> accepted_ = {};
};

}  // namespace

std::vector<daisy_event> daisy_events(std::span<const std::uint8_t> stream,
                                      std::span<const std::size_t> idle_at) {
  const sight seen(stream);
  std::vector<daisy_event> events;
  std::size_t begin = 0;
  bool hunting = true;
  std::vector<std::size_t> ends(idle_at.begin(), idle_at.end());
  ends.push_back(stream.size());
  for (const std::size_t given : ends) {
    const std::size_t end = std::clamp(given, begin, stream.size());
    stretch part(seen, begin, end, events);
    if (hunting) part.run_hunting();
    else part.run_in_step();
    hunting = false;
    begin = end;
  }
  return events;
}

}  // namespace trama_reference
