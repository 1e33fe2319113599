#include "harness.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "proof.hpp"

namespace trama::bench {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double ratio(const outcome& o, std::size_t a, std::size_t b) {
    const auto bytes = [&](std::size_t i) { return static_cast<double>(o.what.contenders[i].bytes); };
    std::vector<double> all;
    for (std::size_t round = 0; round != o.times[a].ns.size(); ++round)
        all.push_back((o.times[a].ns[round] / bytes(a)) / (o.times[b].ns[round] / bytes(b)));
    return median(all);
}

std::size_t find(const race& r, const std::string& name, const std::string& chunk) {
    const auto at = std::find_if(r.contenders.begin(), r.contenders.end(),
                                 [&](const contender& c) { return c.name == name && c.chunk == chunk; });
    return static_cast<std::size_t>(at - r.contenders.begin());
}

std::string size_name(std::size_t bytes) {
    return bytes >> 20 != 0 ? std::to_string(bytes >> 20) + " MiB" : std::to_string(bytes >> 10) + " KiB";
}

namespace {

/// The time that this thread has been running: what other programs do in between does not count.
double thread_ns() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

/// Time of so many passes, for each.
double time_of(const contender& c, unsigned passes, tally& result) {
    const double before = thread_ns();
    for (unsigned pass = 0; pass != passes; ++pass) {
        const tally t = c.run();
        if (pass == 0) result = t;
        else if (!(t == result)) result.messages = ~std::uint64_t{0};  // which nobody else comes to
    }
    return (thread_ns() - before) / passes;
}

constexpr double shortest_round = 1e6;

/// How many passes fill a round. Warms up, too.
unsigned passes_for(const contender& c, tally& result) {
    const auto filling = [](double ns) { return ns >= shortest_round ? 1U : static_cast<unsigned>(std::ceil(shortest_round / std::max(ns, 1.0))); };
    const unsigned guess = filling(time_of(c, 1, result));
    return guess == 1 ? 1 : filling(time_of(c, guess, result));
}

}  // namespace

outcome run(race r, int rounds, const std::function<void(std::size_t, std::size_t)>& progress) {
    outcome o{std::move(r), {}, {}};
    const std::size_t n = o.what.contenders.size();
    const std::size_t all = o.what.answers.size() + n * (static_cast<std::size_t>(rounds) + 1);
    std::size_t done = 0;
    std::vector<statement> heard;
    for (const answer& a : o.what.answers) {
        progress(done++, all);
        heard.push_back({a.question, a.name, a.chunk, a.tell()});
    }
    o.disagreement = contradiction(o.what, heard);
    if (!o.disagreement.empty()) return o;

    o.times.resize(n);
    std::vector<unsigned> passes(n);
    for (std::size_t i = 0; i != n; ++i) {
        progress(done++, all);
        passes[i] = passes_for(o.what.contenders[i], o.times[i].result);
    }
    o.disagreement = contradiction(o.what, heard, o.times);
    if (!o.disagreement.empty()) return o;

    for (int round = 0; round != rounds; ++round)
        for (std::size_t k = 0; k != n; ++k) {
            // Another one goes first each time, so that none always has the cold or the warm place; the order round the circle stays.
            const std::size_t i = (k + static_cast<std::size_t>(round)) % n;
            progress(done++, all);
            tally t;
            o.times[i].ns.push_back(time_of(o.what.contenders[i], passes[i], t));
            if (!(t == o.times[i].result)) o.disagreement = o.what.contenders[i].name + " came to something else the second time";
        }
    return o;
}

}  // namespace trama::bench
