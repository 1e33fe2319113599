#include "tool/ranges.hpp"

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "tool/output.hpp"
#include "tool/part_decoder.hpp"
#include "tool/progress.hpp"
#include "tool/turns.hpp"

namespace trama::tool {

namespace {

/// Nobody can ask the decoder of the range before, so each one says whether the next fits.
template <class F>
bool decode_range(const options& o, const random_file& file) {
    const seam begin = seam_at<F>(file, o.from), end = seam_at<F>(file, o.to);
    if (begin.place >= end.place) return false;
    output out(STDOUT_FILENO);
    progress shown(end.place - begin.join);
    part_decoder<F> decoder(file, o, begin);
    const auto show = [&](std::uint64_t at) { shown.at(at - begin.join); return true; };
    try {
        decoder.run(end, [&](std::string_view line) { out.write(line); }, show);
    } catch (const read_fault&) {
        out.flush();
        throw;
    }
    out.flush();
    if (!decoder.sealed()) complain("decode: byte ", std::to_string(end.place), ": the part behind may not fit, where packets begin there is in doubt; see --jobs");
    return decoder.at_fault() || !decoder.sealed();
}

/// Decodes parts as long as there are any.
template <class F>
void work(turns& all, const random_file& file, const options& o) {
    while (const auto p = all.take()) {
        part_decoder<F> decoder(file, o, p->begin);
        const auto emit = [&](std::string_view line) { all.add(*p, line); };
        const auto go_on = [&](std::uint64_t at) { p->reached = at; return all.wanted(*p); };
        try {
            decoder.run(p->end, emit, go_on);
            // Who joins at a seam where this decoder is in doubt may see something else there.
            while (!decoder.sealed() && all.wait(*p)) {
                all.extend(*p);
                decoder.run(p->end, emit, go_on);
            }
        } catch (const read_fault&) {
            if (!all.wait(*p)) continue;
            all.write(*p);
            throw;
        }
        if (!all.wanted(*p)) continue;
        p->at_fault = decoder.at_fault();
        all.finish(*p);
    }
}

/// How many threads decode: no more than the machine runs at once, as those would only keep lines.
unsigned threads(unsigned jobs) {
    const unsigned cores = std::thread::hardware_concurrency();  // 0: not known
    return cores == 0 ? jobs : std::min(jobs, cores);
}

/// On several cores. With fewer threads than wanted if no more can be started.
template <class F>
bool decode_jobs(const options& o, const random_file& file) {
    constexpr std::uint64_t block = std::uint64_t{1} << 17;
    const unsigned wanted = threads(o.jobs);
    const auto find = [&](const seam& before, std::uint64_t from) {
        try {
            return seam_at<F>(file, from, before);
        } catch (const read_fault&) {
            return seam{file.size(), file.size(), 0};  // the part's decoder meets the fault in its turn
        }
    };
    turns all(file.size(), block, 2 * std::size_t{wanted}, find);
    const auto run = [&] {
        try {
            work<F>(all, file, o);
        } catch (...) {
            all.stop(std::current_exception());
        }
    };
    std::vector<std::thread> others;
    try {
        while (others.size() + 1 < wanted && others.size() < file.size() / block) others.emplace_back(run);
    } catch (const std::exception&) {
        // Those that run are enough.
    }
    run();
    for (std::thread& other : others) other.join();
    return all.result();
}

bool decode_file(const options& o, const random_file& file) {
    switch (o.protocol) {
        case protocol::daisy: return o.ranged ? decode_range<daisy::format>(o, file) : decode_jobs<daisy::format>(o, file);
        case protocol::gateway: return o.ranged ? decode_range<gateway::format>(o, file) : decode_jobs<gateway::format>(o, file);
        case protocol::can: break;
    }
    return decode_jobs<can::format>(o, file);
}

}  // namespace

int decode_parts(const options& o) {
    const random_file file{std::string(o.file)};
    if (!file.error().empty()) {
        complain("decode: ", o.file, ": ", file.error());
        return failed;
    }
    try {
        return decode_file(o, file) ? input_at_fault : all_well;
    } catch (const read_fault& why) {
        complain(why.what());
    } catch (const std::bad_alloc&) {
        complain("decode: not enough memory");
    }
    return failed;
}

}  // namespace trama::tool
