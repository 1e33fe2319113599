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
  bool worth_waiting_for(std::size_t q, std::size_t end) const {
    constexpr std::size_t longest_short = 22;
    for (std::size_t inner = q + 1; inner < end; ++inner) {
      const header begun = documented_header(inner, end);
      if (begun == header::possible) return true;
      if (begun == header::impossible || packet_end(inner) - inner > longest_short) continue;
      if (!complete(inner, end)) return true;
      if (landmark(inner, end)) return at(q + 3) == 0x04 && q + 5 < end && at(q + 5) + 7U == at(q);
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
    if (seen_.landmark(p_, end_)) {
      if (hunter_active_) (void)shadow_finds(rank::landmark);
      vouched_ = true;
      return accept();
    }
    if (!hunter_active_) {
      hunter_active_ = true;
      s_ = p_ + 1;
    }
    const rank judged = seen_.documented_packet(p_, end_) ? rank::documented : rank::undocumented;
    const bool found = shadow_finds(judged);
    if (found && (judged == rank::undocumented || !vouched_)) return lose_step("noise");
    vouched_ = false;
    accept();
  }

  // How much a packet says about the phase it was found in.
  enum class rank { undocumented, documented, landmark };

  // The packet at q, which is complete, is evidence against accepting one of rank `judged`.
  bool evidence(std::size_t q, std::size_t end, rank judged) const {
    return judged == rank::undocumented ? seen_.acceptable_while_hunting(q, end) : seen_.landmark(q, end);
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
    bool found = false;
    while (s_ < seen_end) {
      if (s_ == p_) {
        if (judged == rank::landmark) {
          hunter_active_ = false;
          return found;
        }
        ++s_;
        continue;
      }
      const sight::header header = seen_.documented_header(s_, seen_end);
      if (header == sight::header::impossible) {
        ++s_;
      } else if (header == sight::header::possible) {
        return found;  // waits for more bytes
      } else if (!seen_.complete(s_, seen_end)) {
        if (seen_.worth_waiting_for(s_, seen_end)) return found;
        ++s_;
      } else if (!evidence(s_, seen_end, judged)) {
        ++s_;
      } else if (accepted_.contains(s_)) {
        s_ = p_;
      } else {
        s_ = seen_.packet_end(s_);
        found = true;
      }
    }
    return found;
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
  void hunt(daisy_event loss, std::size_t from) {
    hunter_active_ = false;
    vouched_ = false;
    std::size_t q = from;
    while (q < end_ && !seen_.acceptable_while_hunting(q, end_)) ++q;
    if (q >= end_) return report_rest(loss);
    report(loss, q);
    p_ = q;
    vouched_ = seen_.landmark(q, end_);
    accept();
  }

  // Nothing acceptable is left: says whether a packet was cut off by the end.
  void report_rest(const daisy_event& loss) {
    p_ = end_;
    const std::optional<std::size_t> cut = cut_off_packet(loss);
    if (loss.error == "truncated" || !cut) return report(loss, end_);
    report(loss, *cut);
    report({*cut, 0, "truncated"}, end_);
  }

  std::optional<std::size_t> cut_off_packet(const daisy_event& loss) const {
    for (std::size_t c = loss.offset; c < end_; ++c) {
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
  bool hunter_active_ = false;
  std::size_t s_ = 0;
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
