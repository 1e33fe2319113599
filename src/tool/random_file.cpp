#include "tool/random_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trama::tool {

// Non-blocking, so that a pipe without a writer is refused and not waited for.
random_file::random_file(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat s{};
    char byte;
    if (fd_ < 0 || ::fstat(fd_, &s) != 0) error_ = std::strerror(errno);
    else if (S_ISDIR(s.st_mode)) error_ = std::strerror(EISDIR);
    else if (!S_ISREG(s.st_mode)) error_ = "--jobs and --range need a regular file";
    else if (s.st_size == 0 && ::pread(fd_, &byte, 1, 0) != 0) error_ = "--jobs and --range need a file that tells its size";
    else size_ = static_cast<std::uint64_t>(s.st_size);
}

random_file::~random_file() {
    if (fd_ >= 0) ::close(fd_);
}

std::span<const std::uint8_t> random_file::read(std::uint64_t at, std::span<std::uint8_t> buffer) const {
    buffer = buffer.first(static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), size_ - std::min(at, size_))));
    for (std::size_t got = 0; got != buffer.size();) {
        const ssize_t n = ::pread(fd_, buffer.data() + got, buffer.size() - got, static_cast<off_t>(at + got));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw read_fault(std::string("cannot read: ") + std::strerror(errno));
        if (n == 0) throw read_fault("cannot read: the file has become shorter");
        got += static_cast<std::size_t>(n);
    }
    return buffer;
}

}  // namespace trama::tool
