#include "tool/output.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trama::tool {

namespace {

void write_all(int fd, const char* data, std::size_t size) {
    while (size != 0) {
        const ssize_t n = ::write(fd, data, size);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EPIPE) std::_Exit(all_well);
        if (n < 0) {
            complain("cannot write: ", std::strerror(errno));
            std::_Exit(failed);
        }
        data += n;
        size -= static_cast<std::size_t>(n);
    }
}

}  // namespace

void output::write(std::string_view text) {
    if (text.size() > buffer_.size() - size_) flush();
    if (text.size() > buffer_.size()) return write_all(fd_, text.data(), text.size());
    std::memcpy(buffer_.data() + size_, text.data(), text.size());
    size_ += text.size();
}

void output::write(std::span<const unsigned char> bytes) {
    write(std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void output::flush() {
    write_all(fd_, buffer_.data(), size_);
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
        if (errno == EINTR) continue;
        complain("cannot read: ", std::strerror(errno));
        std::_Exit(failed);
    }
}

void complain(std::span<const std::string_view> parts) {
    std::string line = "trama: ";
    for (const std::string_view part : parts) line += part;
    line += '\n';
    (void)!::write(STDERR_FILENO, line.data(), line.size());
}

}  // namespace trama::tool
