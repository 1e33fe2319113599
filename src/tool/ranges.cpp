#include "tool/ranges.hpp"

#include <deque>
#include <future>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tool/event_line.hpp"
#include "tool/output.hpp"
#include "tool/progress.hpp"
#include "trama/daisy/footing.hpp"
#include "trama/gateway/footing.hpp"

namespace trama::tool {

namespace {

/// A file that is read at any place.
class random_file {
public:
    explicit random_file(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
        struct stat s{};
        regular_ = fd_ >= 0 && ::fstat(fd_, &s) == 0 && S_ISREG(s.st_mode);
        if (regular_) size_ = static_cast<std::uint64_t>(s.st_size);
    }
    random_file(const random_file&) = delete;
    random_file& operator=(const random_file&) = delete;
    ~random_file() { if (fd_ >= 0) ::close(fd_); }

    bool regular() const { return regular_; }
    std::uint64_t size() const { return size_; }
    /// Up to `n` bytes from `at` on; fewer at the end of the file.
    std::vector<std::uint8_t> read(std::uint64_t at, std::size_t n) const {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min<std::uint64_t>(n, size_ - std::min(at, size_))));
        std::size_t got = 0;
        while (got != bytes.size()) {
            const auto part = ::pread(fd_, bytes.data() + got, bytes.size() - got, static_cast<off_t>(at + got));
            if (part <= 0) { bytes.resize(got); break; }
            got += static_cast<std::size_t>(part);
        }
        return bytes;
    }

private:
    int fd_;
    bool regular_ = false;
    std::uint64_t size_ = 0;
};

template <class F>
constexpr bool is_daisy = std::is_same_v<F, daisy::format>;
template <class F>
constexpr std::size_t lead = is_daisy<F> ? daisy::footing_lead : gateway::footing_lead;

/// The footing at or behind `from`, searched in windows that depend on `from` alone: all who ask find the same place.
template <class F>
std::uint64_t find_footing(const random_file& file, std::uint64_t from) {
    std::size_t window = std::size_t{1} << 13;
    while (from != 0 && from < file.size()) {
        const std::uint64_t start = from - std::min<std::uint64_t>(from, lead<F>);
        const auto bytes = file.read(start, window);
        const auto ahead = static_cast<std::size_t>(from - start);
        std::size_t found = bytes.size();
        if (ahead < bytes.size()) {
            if constexpr (is_daisy<F>) found = daisy::footing(bytes, std::max<std::size_t>(ahead, 1));
            else found = ahead == 0 && bytes[0] == gateway::stx ? 0 : gateway::footing(bytes, std::max<std::size_t>(ahead, 1));
        }
        if (found < bytes.size()) return start + found;
        if (start + bytes.size() >= file.size()) return file.size();
        if (window < std::size_t{1} << 24) window *= 4;
        else from += window / 2;
    }
    return from == 0 ? 0 : file.size();
}

/// Where a part begins: the place asked for, and its footing.
struct seam {
    std::uint64_t from = 0, place = 0;
};
template <class F>
seam seam_at(const random_file& file, std::uint64_t from) {
    from = std::min(from, file.size());
    return {from, find_footing<F>(file, from)};
}

/// What one part of the file prints.
struct part {
    std::string text;
    bool at_fault = false;
    bool sealed = true;  ///< The decoder was settled at the end, where the next part begins.
};

/// Decodes what begins in `begin`..`end`. Lines go to `emit`.
template <class F>
part decode_part(const random_file& file, notation style, seam begin, seam end, const auto& emit) {
    part p;
    if (begin.place >= end.place) return p;
    const std::uint64_t start = begin.from - std::min<std::uint64_t>(begin.from, lead<F>);
    typename F::decoder decoder;
    decoder.seek(start);
    std::array<char, longest_line> buffer;
    const auto feed = [&](std::span<const std::uint8_t> units) {
        read<F>(decoder, units, [&](const typename F::event& e) {
            if (e.offset < begin.place || e.offset >= end.place) return;
            text_sink line(buffer);
            p.at_fault = print_event<F>(line, e, style) || p.at_fault;
            line << '\n';
            emit(p, line.view());
        });
    };
    for (std::uint64_t at = start; at < end.place;) {
        const auto bytes = file.read(at, static_cast<std::size_t>(std::min<std::uint64_t>(1 << 16, end.place - at)));
        if (bytes.empty()) break;
        feed(bytes);
        at += bytes.size();
    }
    if (end.place == file.size()) {
        decoder.finish();
        feed({});
    } else if constexpr (is_daisy<F>) {
        p.sealed = decoder.settled() && decoder.offset() == end.place;
    } else {
        const std::uint8_t mark = gateway::stx;  // what stands there ends what came before
        feed({&mark, 1});
    }
    return p;
}

template <class F>
int decode_range(const options& o, const random_file& file, notation style) {
    output out(STDOUT_FILENO);
    const auto p = decode_part<F>(file, style, seam_at<F>(file, o.from), seam_at<F>(file, o.to), [&](part&, std::string_view line) { out.write(line); });
    out.flush();
    return p.at_fault ? input_at_fault : all_well;
}

/// Blocks are decoded on all cores and printed in order. A block whose end is no seam is decoded again with the next.
template <class F>
int decode_jobs(const options& o, const random_file& file, notation style) {
    constexpr std::uint64_t block = std::uint64_t{1} << 18;
    const auto work = [&](seam begin, seam end) {
        return decode_part<F>(file, style, begin, end, [](part& p, std::string_view line) { p.text += line; });
    };
    struct job {
        seam begin, end;
        std::future<part> done;
    };
    output out(STDOUT_FILENO);
    progress shown(file.size());
    std::deque<job> running;
    seam next{}, open_from{};
    bool at_fault = false, sealed = true;
    while (next.place < file.size() || !running.empty()) {
        while (next.place < file.size() && running.size() < 2 * std::size_t{o.jobs}) {
            // From the last seam on, so that a stretch without any is searched once.
            const seam end = seam_at<F>(file, std::max(next.from + block, next.place + 1));
            running.push_back({next, end, std::async(std::launch::async, work, next, end)});
            next = end;
        }
        job first = std::move(running.front());
        running.pop_front();
        part p = first.done.get();
        if (sealed) open_from = first.begin;
        else p = work(open_from, first.end);
        sealed = p.sealed;
        if (!sealed) continue;
        out.write(p.text);
        at_fault = at_fault || p.at_fault;
        shown.at(first.end.place);
    }
    out.flush();
    return at_fault ? input_at_fault : all_well;
}

template <class F>
int decode_file(const options& o, const random_file& file) {
    const notation style = o.text ? notation::plain : notation::json;
    return o.ranged ? decode_range<F>(o, file, style) : decode_jobs<F>(o, file, style);
}

}  // namespace

int decode_parts(const options& o) {
    const random_file file{std::string(o.file)};
    if (!file.regular()) {
        complain("decode: ", o.file, ": --jobs and --range need a regular file that can be read");
        return failed;
    }
    return o.protocol == protocol::daisy ? decode_file<daisy::format>(o, file) : decode_file<gateway::format>(o, file);
}

}  // namespace trama::tool
