#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace trama::tool {

/// Exit statuses of the tool.
enum status : int { all_well = 0, input_at_fault = 1, failed = 2 };

/// A file descriptor with a buffer. Errors end the program: a closed pipe quietly, all others with status 2.
class output {
public:
    explicit output(int fd) noexcept : fd_(fd) {}
    output(const output&) = delete;
    output& operator=(const output&) = delete;

    void write(std::string_view text);
    void write(std::span<const unsigned char> bytes);
    /// Hands everything to the system; to be called before the tool waits for more input.
    void flush();

private:
    int fd_;
    std::size_t size_ = 0;
    std::array<char, 1 << 16> buffer_;
};

/// Reads a file or standard input.
class input {
public:
    /// Opens `path`; `-` is standard input. Not opened: see `error()`.
    explicit input(std::string_view path);
    ~input();
    input(const input&) = delete;
    input& operator=(const input&) = delete;

    /// Empty when the file could be opened, else why not.
    std::string_view error() const noexcept { return error_; }
    /// Bytes of a regular file; 0 of anything else.
    std::uint64_t size() const noexcept;
    /// The next bytes, as soon as there are any; none at the end of the input. Live until the next call.
    std::span<const unsigned char> read();

private:
    int fd_ = 0;
    std::string_view error_;
    std::array<unsigned char, 1 << 16> buffer_;
};

/// Notes that an unfinished line stands on the terminal at standard error: whatever is told next erases it first.
void note_unfinished_line() noexcept;
void erase_unfinished_line();

/// Writes `trama: <parts>` and a line feed to standard error. Control characters in the parts come out as JSON's escapes.
void complain(std::span<const std::string_view> parts);
template <class... Parts>
void complain(const Parts&... parts) {
    const std::array<std::string_view, sizeof...(Parts)> all{std::string_view{parts}...};
    complain(std::span<const std::string_view>{all});
}

}  // namespace trama::tool
