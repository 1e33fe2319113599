#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>

#include <unistd.h>

#include "tool/output.hpp"

namespace trama::tool {

/// A line on the terminal that tells how far a large file is: bytes, rate, time left. Shown only when standard error is
/// a terminal and standard output is none.
class progress {
public:
    explicit progress(std::uint64_t all) : all_(all), shown_(all > 0 && isatty(STDERR_FILENO) != 0 && isatty(STDOUT_FILENO) == 0) {}
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;
    ~progress() { erase_unfinished_line(); }

    void at(std::uint64_t done) {
        if (!shown_) return;
        const auto now = clock::now();
        if (now - last_ < std::chrono::milliseconds(200)) return;
        last_ = now;
        const double seconds = std::chrono::duration<double>(now - start_).count(), rate = static_cast<double>(done) / seconds;
        const double left = rate > 0 && done < all_ ? static_cast<double>(all_ - done) / rate : 0;
        std::fprintf(stderr, "\r\033[K%.0f of %.0f MB, %.0f MB/s, %.0f s left", static_cast<double>(done) / 1e6, static_cast<double>(all_) / 1e6, rate / 1e6, left);
        std::fflush(stderr);
        note_unfinished_line();
    }

private:
    using clock = std::chrono::steady_clock;
    std::uint64_t all_;
    bool shown_;
    clock::time_point start_ = clock::now(), last_ = start_;
};

}  // namespace trama::tool
