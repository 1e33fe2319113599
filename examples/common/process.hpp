#pragma once
// What the example programs share: options, time, Ctrl-C and other ends, sending without blocking, captures.

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
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
/// An option's value that cannot be.
[[noreturn]] inline void refuse(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(2);
}

/// What made the program give up, said by `finish`: by then a terminal is as it was.
struct surrender { bool given = false; std::string why; };
inline surrender gave_up;

/// The program cannot go on: it ends as on Ctrl-C, but with status 2.
inline void give_up(const std::string& why) {
    if (!gave_up.given) gave_up = {true, why};
    stopped = 1;
}
/// Gets out what was printed. When nobody takes it the program comes to its end, without a word if the reader just left.
inline void flush_output() {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    if (errno == EINTR) std::clearerr(stdout);  // a signal, which ends the program anyway
    else give_up(errno == EPIPE ? "" : errno == 0 ? "cannot print" : std::string("cannot print: ") + std::strerror(errno));
}
/// The last thing that `main` calls. `status`, or 2 if the program gave up.
inline int finish(int status) {
    flush_output();
    if (!gave_up.why.empty()) std::fprintf(stderr, "%s\n", gave_up.why.c_str());
    return gave_up.given ? 2 : status;
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
    /// A number from `least` to `most`; a usage error else.
    unsigned long number(const std::string& name, unsigned long least = 0, unsigned long most = UINT32_MAX) const {
        const std::string& v = text(name);
        unsigned long n = 0;
        const auto [end, failed] = std::from_chars(v.data(), v.data() + v.size(), n);
        if (v.empty() || failed == std::errc::invalid_argument || end != v.data() + v.size()) refuse("--" + name + " " + v + ": a number is needed");
        if (failed != std::errc{} || n < least || n > most) refuse("--" + name + " " + v + ": not in " + std::to_string(least) + ".." + std::to_string(most));
        return n;
    }

private:
    std::string help_;
    std::map<std::string, bool> known_;
    std::map<std::string, std::string> values_;
};

/// A file that everything sent over a line goes into, its folder made if there is none; nothing when no path is given.
/// Half a capture is none: when it cannot be written the program gives up.
class capture {
public:
    explicit capture(const std::filesystem::path& path) : path_(path.string()) {
        if (path.empty()) return;
        std::error_code failed;
        if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
        if (!failed) file_ = std::fopen(path.c_str(), "wb");
        else errno = failed.value();
        if (file_ == nullptr) die(path_);
    }
    capture(const capture&) = delete;
    capture& operator=(const capture&) = delete;
    ~capture() { if (file_ != nullptr) std::fclose(file_); }

    void write(std::span<const std::uint8_t> bytes) {
        if (file_ == nullptr) return;
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_) == bytes.size() && std::fflush(file_) == 0) return;
        give_up(path_ + ": " + std::strerror(errno));
        std::fclose(file_);
        file_ = nullptr;
    }
    void line(const std::string& text) { write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

private:
    std::string path_;
    std::FILE* file_ = nullptr;
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
