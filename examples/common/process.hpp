#pragma once
// What the example programs share: options, time, Ctrl-C, sending without blocking, captures, faults.

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace example {

using octets = std::vector<std::uint8_t>;

/// Milliseconds since some moment.
inline std::uint64_t now() {
    using namespace std::chrono;
    return static_cast<std::uint64_t>(duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count());
}

/// Set by Ctrl-C and by the supervisor: the program comes to its end.
inline volatile sig_atomic_t stopped = 0;

inline void catch_signals() {
    struct sigaction action{};
    action.sa_handler = [](int) { stopped = 1; };
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    signal(SIGPIPE, SIG_IGN);
}

[[noreturn]] inline void die(const std::string& why) {
    std::fprintf(stderr, "%s%s%s\n", why.c_str(), errno != 0 ? ": " : "", errno != 0 ? std::strerror(errno) : "");
    std::exit(2);
}

/// Command-line options `--name VALUE` and switches `--name`. Prints the help that `add` collects.
class options {
public:
    explicit options(std::string what) : help_(std::move(what)) {}

    /// `value` empty: a switch.
    void add(const std::string& name, const std::string& value, const std::string& meaning, const std::string& otherwise = {}) {
        known_[name] = !value.empty();
        values_[name] = otherwise;
        const std::string left = "  --" + name + (value.empty() ? "" : " " + value);
        help_ += "\n" + left + std::string(left.size() < 24 ? 24 - left.size() : 1, ' ') + meaning + (otherwise.empty() ? "" : " (" + otherwise + ")");
    }
    void parse(int argc, char** argv) {
        for (int i = 1; i < argc; ++i) {
            const std::string arg = argv[i];
            if (arg == "--help") {
                std::printf("%s\n", help_.c_str());
                std::exit(0);
            }
            const auto found = arg.rfind("--", 0) == 0 ? known_.find(arg.substr(2)) : known_.end();
            if (found == known_.end() || (found->second && i + 1 == argc)) {
                std::fprintf(stderr, "%s: what is this?\n%s\n", arg.c_str(), help_.c_str());
                std::exit(2);
            }
            values_[found->first] = found->second ? argv[++i] : "yes";
        }
    }
    const std::string& text(const std::string& name) const { return values_.at(name); }
    bool has(const std::string& name) const { return !text(name).empty(); }
    /// A number, not negative; a usage error else.
    unsigned long number(const std::string& name) const {
        const std::string& v = text(name);
        char* end = nullptr;
        const unsigned long n = std::strtoul(v.c_str(), &end, 10);
        if (v.empty() || *end != '\0' || v[0] == '-') {
            std::fprintf(stderr, "--%s %s: a number is needed\n", name.c_str(), v.c_str());
            std::exit(2);
        }
        return n;
    }

private:
    std::string help_;
    std::map<std::string, bool> known_;
    std::map<std::string, std::string> values_;
};

/// A file that everything sent over a line goes into, its folder made if there is none; nothing when no path is given.
class capture {
public:
    explicit capture(const std::filesystem::path& path) {
        if (path.empty()) return;
        std::error_code failed;
        if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
        if (!failed) file_ = std::fopen(path.c_str(), "wb");
        else errno = failed.value();
        if (file_ == nullptr) die(path.string());
    }
    capture(const capture&) = delete;
    capture& operator=(const capture&) = delete;
    ~capture() { if (file_ != nullptr) std::fclose(file_); }

    void write(std::span<const std::uint8_t> bytes) {
        if (file_ == nullptr) return;
        std::fwrite(bytes.data(), 1, bytes.size(), file_);
        std::fflush(file_);
    }
    void line(const std::string& text) { write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

private:
    std::FILE* file_ = nullptr;
};

/// Odds of damage: one in so many bytes or frames; 0 is never.
struct odds {
    unsigned long flip = 0, drop = 0, duplicate = 0, delay = 0;

    static void add_to(options& o, const std::string& unit) {
        o.add("flip", "N", "flip a bit in one of N " + unit, "0");
        o.add("drop", "N", "lose one of N " + unit, "0");
        o.add("duplicate", "N", "double one of N " + unit, "0");
        o.add("delay", "N", "hold one of N pieces up for 30 ms", "0");
        o.add("seed", "N", "start of the random numbers for all that", "1");
    }
    static odds of(const options& o) { return {o.number("flip"), o.number("drop"), o.number("duplicate"), o.number("delay")}; }
};

/// Decides what happens to the next unit.
class fate {
public:
    fate(const odds& o, unsigned long seed) : odds_(o), random_(static_cast<std::mt19937::result_type>(seed)) {}

    bool flips() { return happens(odds_.flip); }
    bool drops() { return happens(odds_.drop); }
    bool doubles() { return happens(odds_.duplicate); }
    bool delays() { return happens(odds_.delay); }
    std::uint8_t one_bit() { return static_cast<std::uint8_t>(1U << random_() % 8); }
    std::uint64_t count() const { return count_; }

private:
    bool happens(unsigned long one_in) {
        const bool now = one_in != 0 && random_() % one_in == 0;
        count_ += now ? 1U : 0U;
        return now;
    }
    odds odds_;
    std::mt19937 random_;
    std::uint64_t count_ = 0;
};

/// Bytes on their way out of a file descriptor that does not block.
class outbox {
public:
    void add(std::span<const std::uint8_t> bytes) { waiting_.insert(waiting_.end(), bytes.begin(), bytes.end()); }
    bool empty() const { return done_ == waiting_.size(); }
    std::size_t size() const { return waiting_.size() - done_; }
    void clear() { waiting_.clear(); done_ = 0; }
    /// False when the other end is gone.
    bool flush(int fd) {
        while (!empty()) {
            const ssize_t n = ::write(fd, waiting_.data() + done_, waiting_.size() - done_);
            if (n < 0) return errno == EAGAIN || errno == EINTR;
            done_ += static_cast<std::size_t>(n);
        }
        clear();
        return true;
    }

private:
    octets waiting_;
    std::size_t done_ = 0;
};

inline void unblock(int fd) { fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_NONBLOCK); }

}  // namespace example
