// trama_bench: how fast the library is, beside what the machine could do and what one writes by hand.
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <string_view>

#include "formats/can.hpp"
#include "formats/daisy.hpp"
#include "formats/gateway.hpp"
#include "report.hpp"
#include "targets.hpp"

namespace {

using namespace trama::bench;

constexpr std::string_view help =
    "usage: trama_bench [--quick] [--check] [--only PATTERN] [--rounds N] [--json] [--list]\n"
    "\n"
    "Times trama beside what the machine could do at best and beside hand-written code. Before anything is timed, the\n"
    "results of all are compared, order included, with each other, with what the streams were made of and with a second\n"
    "implementation. Ratios are medians over rounds in which the contenders take turns, per byte.\n"
    "\n"
    "Times are ns for each message that the stream was made of, whether it is found or damaged; of a stream that was made\n"
    "of none (garbage, hostile) ns for the whole stream.\n"
    "\n"
    "  --quick         shorter streams, under a minute in all; caches and predictors then flatter everybody\n"
    "  --check         only what the targets ask for, then the table of targets\n"
    "  --only PATTERN  only races whose name contains PATTERN (format/workload/size/task)\n"
    "  --rounds N      rounds, 9 if not said otherwise and never fewer\n"
    "  --json          one JSON object instead of the tables, in the same unit; a race that disagrees is not in it\n"
    "  --list          the names of the races\n"
    "\n"
    "Status: 0 if all results agree, 1 if some don't (it is said on the standard error), 2 if the command line is wrong or\n"
    "names no race, or the output cannot be written. Times decide nothing.\n";

struct options {
    bool quick = false, check = false, json = false, list = false;
    std::string only;
    int rounds = 9;
};

bool wanted_by_target(const std::string& id, const scale& sizes) {
    for (const target& t : targets())
        if (race_of(t, sizes) == id) return true;
    return false;
}

/// Of a race that only the targets ask for, the contenders that they name.
void keep_targets(race& r, const scale& sizes) {
    std::erase_if(r.contenders, [&](const contender& c) {
        if (c.name == "trama" && c.chunk == "whole") return false;
        for (const target& t : targets())
            if (race_of(t, sizes) == r.id() && ((c.name == t.contender && c.chunk == t.chunk) || (c.name == t.against && c.chunk == "whole"))) return false;
        return true;
    });
    // Hand-written code still has its say, the library only where it is timed.
    std::erase_if(r.answers, [&](const answer& a) { return a.name.starts_with("trama") && !a.chunk.empty() && find(r, a.name, a.chunk) == r.contenders.size(); });
}

bool parse_rounds(std::string_view digits, int& rounds) {
    const auto [end, bad] = std::from_chars(digits.data(), digits.data() + digits.size(), rounds);
    return bad == std::errc{} && end == digits.data() + digits.size() && rounds >= 9;
}

/// The word that cannot be understood; null when all can.
const char* parse(int argc, char** argv, options& o) {
    for (int i = 1; i != argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--quick") o.quick = true;
        else if (word == "--check") o.check = true;
        else if (word == "--json") o.json = true;
        else if (word == "--list") o.list = true;
        else if (word == "--only" && i + 1 != argc) o.only = argv[++i];
        else if (word == "--rounds" && i + 1 != argc && parse_rounds(argv[++i], o.rounds)) continue;
        else return argv[i];
    }
    return nullptr;
}

void show_progress(const std::string& id, std::size_t race, std::size_t races, std::size_t done, std::size_t all) {
    if (isatty(STDERR_FILENO) == 0) return;
    std::fprintf(stderr, "\r\033[K[%zu/%zu] %s %3zu %%", race, races, id.c_str(), 100 * done / all);
    std::fflush(stderr);
}
void clear_progress() {
    if (isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "\r\033[K");
}

int run_all(const std::vector<entry>& entries, const options& o, const scale& sizes) {
    std::vector<outcome> outcomes;
    bool agreed = true;
    const circumstances c = here();
    if (!o.json) std::printf("machine:  %s\ncompiler: %s\nflags:    %s\ncommit:   %s\n", c.machine.c_str(), c.compiler.c_str(), c.flags.c_str(), c.commit.c_str());
    for (std::size_t i = 0; i != entries.size(); ++i) {
        show_progress(entries[i].id, i + 1, entries.size(), 0, 1);
        race r = entries[i].build();
        if (o.check) keep_targets(r, sizes);
        outcomes.push_back(run(std::move(r), o.rounds, [&](std::size_t done, std::size_t all) { show_progress(entries[i].id, i + 1, entries.size(), done, all); }));
        outcome& last = outcomes.back();
        for (contender& one : last.what.contenders) one.run = nullptr;  // lets go of the streams
        last.what.answers.clear();
        agreed = agreed && last.disagreement.empty();
        clear_progress();
        if (!last.disagreement.empty()) std::fprintf(stderr, "%s: %s\n", last.what.id().c_str(), last.disagreement.c_str());
        if (!o.json) std::printf("%s", table(last).c_str());
        std::fflush(stdout);
    }
    if (o.json) std::printf("%s", json(c, outcomes).c_str());
    if (o.check) std::fprintf(o.json ? stderr : stdout, "\n%s", table(outcomes, sizes).c_str());
    return agreed ? 0 : 1;
}

int bench(int argc, char** argv) {
    options o;
    if (argc == 2 && std::string_view(argv[1]) == "--help") {
        std::fwrite(help.data(), 1, help.size(), stdout);
        return 0;
    }
    if (const char* wrong = parse(argc, argv, o)) {
        std::fprintf(stderr, "trama_bench: %s: no option, or not what it takes (--rounds: a number from 9 on)\n", wrong);
        std::fwrite(help.data(), 1, help.size(), stderr);
        return 2;
    }
    scale sizes;
    if (o.quick) sizes = {std::size_t{1} << 20, std::size_t{64} << 10};
    std::vector<entry> entries;
    add_daisy(entries, sizes);
    add_can(entries, sizes);
    add_gateway(entries, sizes);
    std::erase_if(entries, [&](const entry& e) {
        return e.id.find(o.only) == std::string::npos || (o.check && !wanted_by_target(e.id, sizes));
    });
    if (entries.empty()) {
        std::fprintf(stderr, "no race %sis called %s; --list names them all\n", o.check ? "that a target asks for " : "", o.only.c_str());
        return 2;
    }
    if (o.list) {
        for (const entry& e : entries) std::printf("%s\n", e.id.c_str());
        return 0;
    }
    return run_all(entries, o, sizes);
}

}  // namespace

int main(int argc, char** argv) {
    const int status = bench(argc, argv);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    std::fprintf(stderr, "the output cannot be written\n");
    return 2;
}
