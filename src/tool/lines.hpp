#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace trama::tool {

/// Cuts a byte stream into lines of bounded length. A line without its end at the end of the input counts too.
class line_reader {
public:
    static constexpr std::size_t longest = 1 << 16;

    /// `before` lines precede the stream.
    explicit line_reader(std::uint64_t before = 0) noexcept : number_(before) {}

    /// Calls `f(line, too_long)` for every line that `bytes` completes; of one that is too long, its beginning.
    void read(std::span<const unsigned char> bytes, auto&& f) {
        while (!bytes.empty()) {
            const void* end = std::memchr(bytes.data(), '\n', bytes.size());
            const std::size_t n = end == nullptr ? bytes.size() : static_cast<std::size_t>(static_cast<const unsigned char*>(end) - bytes.data());
            for (std::size_t i = 0; i != n && line_.size() < longest; ++i) line_.push_back(static_cast<char>(bytes[i]));
            too_long_ = too_long_ || line_.size() == longest;
            if (end == nullptr) { open_ = true; return; }
            bytes = bytes.subspan(n + 1);
            deliver(f);
        }
    }
    /// The input ended.
    void finish(auto&& f) {
        if (open_) deliver(f);
    }
    /// Number of the line delivered last, from 1.
    std::uint64_t number() const noexcept { return number_; }

private:
    void deliver(auto& f) {
        ++number_;
        open_ = false;
        f(std::string_view{line_}, too_long_);
        line_.clear();
        too_long_ = false;
    }
    std::string line_;
    std::uint64_t number_;
    bool open_ = false;  ///< Bytes of a line without its end have come.
    bool too_long_ = false;
};

}  // namespace trama::tool
