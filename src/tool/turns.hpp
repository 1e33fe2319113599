#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include <unistd.h>

#include "tool/output.hpp"
#include "tool/progress.hpp"
#include "tool/seam.hpp"

namespace trama::tool {

/// A part of a file that one thread decodes.
struct part {
    seam begin, end;
    std::string text{};         ///< Lines that are not written yet.
    std::uint64_t reached = 0;  ///< How far the decoder is.
    bool at_fault = false;
    bool done = false;
    std::atomic<bool> dropped = false;  ///< Another part's decoder goes on over this one.
};

/// Hands out the parts of a file to threads and writes their lines in the file's order. It is always the first part's
/// turn: that one's lines are written as they come, those of the others wait in bounded memory.
class turns {
public:
    using search = std::function<seam(const seam& before, std::uint64_t from)>;

    /// Parts of some `block` bytes, at most `most` of them at a time, from each other at the seams that `find` gives, each
    /// asked for with the one before it. The more parts, the fewer of each one's lines wait, but always some.
    turns(std::uint64_t size, std::uint64_t block, std::size_t most, search find);

    /// The next part to be decoded; waits while there are too many, null if there are no more.
    std::shared_ptr<part> take();
    /// One more line of the part. Waits for its turn if too much of it is kept.
    void add(part& p, std::string_view line);
    /// Whether it became the part's turn; false if the part is dropped or the work is stopped.
    bool wait(part& p);
    /// Writes what the part has, whose turn it is.
    void write(part& p);
    /// Moves the end of the part whose turn it is to the next one's, which is dropped.
    void extend(part& p);
    /// The part is decoded. Writes it, and what waited for it, if it is its turn.
    void finish(part& p);
    /// Nobody takes or waits any more.
    void stop(std::exception_ptr why);
    bool wanted(const part& p) const { return !p.dropped && !stopped_; }

    /// Once no thread works any more: whether some input was at fault. Rethrows why the work was stopped.
    bool result();

private:
    bool is_first(const part& p) const { return !parts_.empty() && parts_.front().get() == &p; }
    void cut(std::unique_lock<std::mutex>& lock);

    std::uint64_t size_, block_;
    std::size_t most_;
    std::size_t kept_;  ///< Of a part's lines that wait, bytes.
    search find_;
    output out_{STDOUT_FILENO};  // this and `shown_` are for the thread of the first part
    progress shown_;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::shared_ptr<part>> parts_;
    seam next_{};  ///< Where the next part begins.
    bool cutting_ = false, at_fault_ = false;
    std::exception_ptr why_;
    std::atomic<bool> stopped_ = false;
};

}  // namespace trama::tool
