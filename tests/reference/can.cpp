#include <algorithm>
#include <cmath>
#include <map>

#include "can_message.hpp"
#include "can_table.hpp"
#include "candump.hpp"
#include "reference.hpp"

namespace trama_reference {

namespace {

constexpr std::uint64_t second = 1'000'000'000;

std::string line_head(std::size_t line) {
  return concat({"{", member("protocol", quoted("can")), next_member("line", static_cast<long long>(line))});
}

// The message of one identifier that is under way.
struct partial {
  const can_form* form = nullptr;
  std::size_t line = 0;
  std::size_t frames = 0;
  octets data = {};
  log_time last = {};
};

class reassembly {
 public:
  explicit reassembly(double timeout_seconds) {
    const double in_range = std::clamp(timeout_seconds, 0.0, 9e9);
    const auto nanoseconds = static_cast<std::uint64_t>(std::llround(in_range * static_cast<double>(second)));
    timeout_ = {nanoseconds / second, nanoseconds % second};
  }

  std::vector<std::string> lines = {};

  void feed_line(std::size_t number, std::string_view line) {
    const std::optional<log_frame> frame = parse_candump(line);
    if (!frame) {
      lines.push_back(concat({line_head(number), next_member("error", quoted("bad_line")), "}"}));
      return;
    }
    tick(frame->time);
    if (frame->standard && frame->id >= 0x80 && frame->id <= 0x82) feed(number, *frame);
  }

  // All of them end at the same moment: in the order of their first frames.
  void end() {
    give_up("truncated", [](const partial&) { return true; },
            [](const partial& a, const partial& b) { return a.line < b.line; });
  }

 private:
  // The one that stalled first is the first to be over time.
  void tick(const log_time& now) {
    give_up("timed_out", [&](const partial& one) { return older_than_timeout(one.last, now); },
            [](const partial& a, const partial& b) { return a.last < b.last || (a.last == b.last && a.line < b.line); });
  }

  // Reports and forgets those that are over; ascending identifiers where `earlier` sees no difference.
  void give_up(const std::string& code, auto over, auto earlier) {
    std::vector<std::uint32_t> ids;
    for (const auto& [id, under_way] : partials_) {
      if (over(under_way)) ids.push_back(id);
    }
    std::stable_sort(ids.begin(), ids.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return earlier(partials_.at(a), partials_.at(b)); });
    for (const std::uint32_t id : ids) {
      error(id, partials_.at(id), code);
      partials_.erase(id);
    }
  }

  bool older_than_timeout(const log_time& last, const log_time& now) const {
    if (now < last) return false;
    log_time age = {now.seconds - last.seconds, now.nanoseconds};
    if (age.nanoseconds < last.nanoseconds) {
      --age.seconds;
      age.nanoseconds += second;
    }
    age.nanoseconds -= last.nanoseconds;
    return age > timeout_;
  }

  void feed(std::size_t line, const log_frame& frame) {
    const auto found = partials_.find(frame.id);
    if (found == partials_.end()) return first_frame(line, frame);
    partial& under_way = found->second;
    if (under_way.form->lengths[under_way.frames] != frame.data.size()) {
      error(frame.id, under_way, "incomplete");
      partials_.erase(found);
      return first_frame(line, frame);
    }
    under_way.data.insert(under_way.data.end(), frame.data.begin(), frame.data.end());
    ++under_way.frames;
    under_way.last = frame.time;
    if (under_way.frames < under_way.form->lengths.size()) return;
    message(frame.id, under_way);
    partials_.erase(found);
  }

  void first_frame(std::size_t line, const log_frame& frame) {
    partial started = {nullptr, line, 1, frame.data, frame.time};
    if (frame.data.size() < 3) return error(frame.id, started, "bad_length");
    const std::uint8_t letter = frame.data[2];
    if (!known_can_letter(letter)) return error(frame.id, started, "unknown_message");
    started.form = find_can_form(letter, frame.data.size());
    if (started.form == nullptr) return error(frame.id, started, "bad_length");
    if (started.form->lengths.size() == 1) return message(frame.id, started);
    partials_[frame.id] = started;
  }

  static std::string head(std::uint32_t id, const partial& frames) {
    return concat({line_head(frames.line), next_member("frames", static_cast<long long>(frames.frames)),
                   next_member("id", id)});
  }

  void error(std::uint32_t id, const partial& frames, const std::string& code, const std::string& rest = "") {
    lines.push_back(
        concat({head(id, frames), next_member("error", quoted(code)), bytes_member(frames.data), rest, "}"}));
  }

  void message(std::uint32_t id, const partial& frames) {
    const can_meaning meaning = read_can_message(*frames.form, frames.data);
    if (!meaning.bad_number.empty()) {
      return error(id, frames, "bad_number", next_member("field", quoted(meaning.bad_number)));
    }
    lines.push_back(concat({head(id, frames), next_member("message", quoted(frames.form->name)),
                            next_member("fields", meaning.fields), violations_member(meaning.violations), "}"}));
  }

  log_time timeout_ = {};
  std::map<std::uint32_t, partial> partials_ = {};
};

}  // namespace

std::vector<std::string> can_lines(std::string_view candump_log, double timeout_seconds) {
  reassembly reassembled(timeout_seconds);
  std::size_t number = 0;
  while (!candump_log.empty()) {
    const std::size_t line_feed = candump_log.find('\n');
    std::string_view line = candump_log.substr(0, line_feed);
    candump_log.remove_prefix(line_feed == std::string_view::npos ? candump_log.size() : line_feed + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    reassembled.feed_line(++number, line);
  }
  reassembled.end();
  return reassembled.lines;
}

}  // namespace trama_reference
