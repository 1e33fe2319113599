#include "tool/output.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trama::tool {

namespace {

/// Whether a call that failed is to be made again. Whoever shares a pipe with the tool may have made it non-blocking;
/// then this waits for the `event`.
bool again(int fd, short event) {
    if (errno == EINTR) return true;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
    pollfd one{fd, event, 0};
    (void)::poll(&one, 1, -1);
    return true;
}

/// False if not all could be written, with the reason in errno.
bool write_all(int fd, std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = ::write(fd, text.data(), text.size());
        if (n >= 0) text.remove_prefix(static_cast<std::size_t>(n));
        else if (!again(fd, POLLOUT)) return false;
    }
    return true;
}

std::atomic<bool> unfinished_line = false;

void write_or_end(int fd, std::string_view text) {
    if (write_all(fd, text)) return;
    if (errno == EPIPE) {
        erase_unfinished_line();
        std::_Exit(all_well);
    }
    complain("cannot write: ", std::strerror(errno));
    std::_Exit(failed);
}

/// Appends text of which some may come from the input: a control character, which would break the line or steer the
/// terminal, is escaped as in JSON.
void append_shown(std::string& line, std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    for (std::size_t i = 0; i != text.size(); ++i) {
        const bool two = text[i] == '\xC2' && i + 1 != text.size() && (text[i + 1] & '\xE0') == '\x80';  // U+0080..U+009F in UTF-8
        if (two) ++i;
        const auto c = static_cast<unsigned char>(text[i]);
        if (two || c < 0x20 || c == 0x7F) line.append("\\u00").append({digits[c >> 4], digits[c & 15]});
        else line += text[i];
    }
}

}  // namespace

void output::write(std::string_view text) {
    if (text.size() > buffer_.size() - size_) flush();
    if (text.size() > buffer_.size()) return write_or_end(fd_, text);
    std::memcpy(buffer_.data() + size_, text.data(), text.size());
    size_ += text.size();
}

void output::write(std::span<const unsigned char> bytes) {
    write(std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void output::flush() {
    write_or_end(fd_, std::string_view{buffer_.data(), size_});
    size_ = 0;
}

input::input(std::string_view path) {
    if (path == "-") return;
    fd_ = ::open(std::string{path}.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat about {};
    if (fd_ < 0) error_ = std::strerror(errno);
    else if (::fstat(fd_, &about) == 0 && S_ISDIR(about.st_mode)) error_ = std::strerror(EISDIR);
}

input::~input() {
    if (fd_ > 0) ::close(fd_);
}

std::uint64_t input::size() const noexcept {
    struct stat s{};
    return ::fstat(fd_, &s) == 0 && S_ISREG(s.st_mode) ? static_cast<std::uint64_t>(s.st_size) : 0;
}

std::span<const unsigned char> input::read() {
    for (;;) {
        const ssize_t n = ::read(fd_, buffer_.data(), buffer_.size());
        if (n >= 0) return {buffer_.data(), static_cast<std::size_t>(n)};
        if (again(fd_, POLLIN)) continue;
        complain("cannot read: ", std::strerror(errno));
        std::_Exit(failed);
    }
}

void note_unfinished_line() noexcept { unfinished_line = true; }

void erase_unfinished_line() {
    if (unfinished_line.exchange(false)) (void)write_all(STDERR_FILENO, "\r\033[K");
}

void complain(std::span<const std::string_view> parts) {
    erase_unfinished_line();
    std::string line = "trama: ";
    for (const std::string_view part : parts) append_shown(line, part);
    line += '\n';
    (void)write_all(STDERR_FILENO, line);  // where else could it be told?
}

}  // namespace trama::tool
