#pragma once
// Races: contenders that do the same work on the same stream, proved right first and then timed in interleaved rounds.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace trama::bench {

/// What somebody made of a stream.
struct tally {
    std::uint64_t messages = 0;
    std::uint64_t sum = 0;     ///< Over lengths or field values, so that no work can be left out.
    std::uint64_t errors = 0;  ///< Error events, and invalid messages where that is asked.
    friend bool operator==(const tally&, const tally&) = default;
};

enum class role {
    limit,     ///< What the machine could do at best; the first one of a race is what ratios refer to.
    baseline,  ///< Hand-written code; the last one of a race is the good one, what ratios refer to.
    library,
};

/// Somebody who is timed. All but the limits must come to the same.
struct contender {
    std::string name;
    std::string chunk;  ///< "whole" or the size of the pieces that the stream came in.
    role part;
    std::uint64_t bytes;
    std::uint64_t messages;  ///< That its stream was made of; 0 of noise.
    std::function<tally()> run;
};

/// What somebody says to a question before anything is timed: a contender with code that also heeds the order of fields
/// and messages, or a witness that is never timed. All answers to a question must be the same, and to at least one
/// question each contender must be answered by somebody else.
struct answer {
    std::string question;
    std::string name;
    std::string chunk;  ///< Of a contender; empty of a witness.
    std::function<tally()> tell;
};

/// The question that every contender answers.
inline const std::string whole_stream = "the whole stream";

struct race {
    std::string format, workload, size, task;
    std::vector<contender> contenders{};
    std::vector<answer> answers{};

    std::string id() const { return format + '/' + workload + '/' + size + '/' + task; }
};

/// The times of one contender, in ns for the whole stream, round by round.
struct timing {
    tally result;
    std::vector<double> ns;
};

struct outcome {
    race what;
    std::vector<timing> times;  ///< One for each contender.
    std::string disagreement;   ///< Empty, or who came to what.
};

/// Median of `values`, which must not be empty.
double median(std::vector<double> values);
/// Median over the rounds of the time per byte of contender `a` as a multiple of that of `b`.
double ratio(const outcome& o, std::size_t a, std::size_t b);
/// Position of a contender, or the number of contenders.
std::size_t find(const race& r, const std::string& name, const std::string& chunk = "whole");

/// One race that can be run, built when it is its turn.
struct entry {
    std::string id;
    std::function<race()> build;
};
/// How large the streams are, in bytes.
struct scale {
    std::size_t large = std::size_t{64} << 20;  ///< Far beyond the caches and what branch predictors can learn.
    std::size_t small = std::size_t{256} << 10;
};
/// "64 MiB"
std::string size_name(std::size_t bytes);

/// Hears all answers, runs every contender once and compares; then, if they agree, `rounds` interleaved rounds. In each a
/// contender runs as often as a millisecond allows, at least once, so that reading the clock does not count.
/// `progress(done, all)` is called before each step.
outcome run(race r, int rounds, const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace trama::bench
