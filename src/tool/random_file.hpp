#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace trama::tool {

/// Why a file could not be read.
struct read_fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A stored file that is read at any place, by several threads at once. Only the bytes that it had at first count.
class random_file {
public:
    explicit random_file(const std::string& path);
    ~random_file();
    random_file(const random_file&) = delete;
    random_file& operator=(const random_file&) = delete;

    /// Empty when it is open, regular, and has the size that it tells, unlike those of /proc; else what is wrong.
    const std::string& error() const noexcept { return error_; }
    std::uint64_t size() const noexcept { return size_; }
    /// What lies at `at`, as much as goes into `buffer`, less only at the end. Throws `read_fault`.
    std::span<const std::uint8_t> read(std::uint64_t at, std::span<std::uint8_t> buffer) const;

private:
    int fd_;
    std::string error_;
    std::uint64_t size_ = 0;
};

}  // namespace trama::tool
