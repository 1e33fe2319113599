#include "harness.hpp"

#include <algorithm>
#include <ctime>
#include <map>

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

std::string words(const contender& c, const tally& t) {
    return c.name + " (" + c.chunk + "): " + std::to_string(t.messages) + " messages, sum " + std::to_string(t.sum) +
           ", errors " + std::to_string(t.errors);
}

std::string compare(const outcome& o, const std::vector<tally>& proofs) {
    std::map<int, std::size_t> first;
    for (std::size_t i = 0; i != o.times.size(); ++i) {
        const contender& c = o.what.contenders[i];
        if (c.group == not_compared) continue;
        const auto [at, fresh] = first.emplace(c.group, i);
        if (!fresh && !(proofs[at->second] == proofs[i]))
            return words(o.what.contenders[at->second], proofs[at->second]) + "\n  but " + words(c, proofs[i]);
    }
    return {};
}

}  // namespace

outcome run(race r, int rounds, const std::function<void(std::size_t, std::size_t)>& progress) {
    outcome o{std::move(r), {}, {}};
    const std::size_t n = o.what.contenders.size();
    const std::size_t all = n * (static_cast<std::size_t>(rounds) + 1);
    o.times.resize(n);
    std::vector<tally> proofs(n);
    std::size_t done = 0;
    for (std::size_t i = 0; i != n; ++i) {  // warms up, too
        progress(done++, all);
        const contender& c = o.what.contenders[i];
        o.times[i].result = c.run();
        if (c.proof) proofs[i] = c.proof();
        else proofs[i] = o.times[i].result;
    }
    o.disagreement = compare(o, proofs);
    if (!o.disagreement.empty()) return o;
    for (int round = 0; round != rounds; ++round)
        for (std::size_t k = 0; k != n; ++k) {
            // Another one goes first each time, so that none always runs after the same neighbour.
            const std::size_t i = (k + static_cast<std::size_t>(round)) % n;
            progress(done++, all);
            const double before = thread_ns();
            const tally t = o.what.contenders[i].run();
            o.times[i].ns.push_back(thread_ns() - before);
            if (!(t == o.times[i].result)) o.disagreement = o.what.contenders[i].name + " came to something else the second time";
        }
    return o;
}

}  // namespace trama::bench
