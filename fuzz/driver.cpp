// A main() for compilers without libFuzzer: replays files and folders, and throws plain random mutations at the target on request.
// AFL and Honggfuzz start it as a program that takes one file (@@, ___FILE___), or standard input when there is no argument.
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t a_size, const std::uint8_t* b,
                                                               std::size_t b_size, std::uint8_t* out, std::size_t max_size, unsigned seed);
/// Prints what an input puts on the wire, in the form that `trama decode` reads; the harness defines it.
extern "C" [[gnu::weak]] void trama_fuzz_print_wire(const std::uint8_t* data, std::size_t size);
/// Prints which messages the inputs have reached; the harness defines it.
extern "C" [[gnu::weak]] void trama_fuzz_census();
extern "C" [[gnu::weak]] void __sanitizer_set_death_callback(void (*callback)());

namespace {

using octets = std::vector<std::uint8_t>;

struct options {
    std::vector<std::string> paths;
    std::string failing_input = "crash-input";  ///< Where a mutated input that fails is left.
    std::size_t runs = 0;                       ///< Mutated inputs to try after the replay.
    std::size_t max_len = 4096;
    unsigned seed = 1;
    bool print_wire = false;
    bool census = false;
};

// What the signal handlers may look at: set before every run.
const char* current_name = nullptr;
const octets* current_input = nullptr;
bool current_is_mutated = false;
std::string failing_path;

void say(const char* words) { (void)!::write(2, words, std::strlen(words)); }

/// Names the input that failed, and keeps it when it exists nowhere else.
void on_death() {
    if (current_name == nullptr) return;
    say("\nwhile running ");
    say(current_name);
    say("\n");
    if (current_is_mutated) {
        if (std::FILE* f = std::fopen(failing_path.c_str(), "wb")) {
            (void)!std::fwrite(current_input->data(), 1, current_input->size(), f);
            std::fclose(f);
            say("the input is in ");
            say(failing_path.c_str());
            say("\n");
        }
    }
    current_name = nullptr;
}

void on_signal(int number) {
    on_death();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

// Files are read through the system's own calls: MemorySanitizer follows those, but not the C++ library's streams.

/// Everything that `in` holds; false when reading fails.
bool read_all(std::FILE* in, octets& out) {
    std::uint8_t part[4096];
    for (std::size_t n = 0; (n = std::fread(part, 1, sizeof part, in)) != 0;) out.insert(out.end(), part, part + n);
    return std::ferror(in) == 0;
}
bool read_file(const std::string& path, octets& out) {
    std::FILE* in = std::fopen(path.c_str(), "rb");
    if (in == nullptr) return false;
    const bool good = read_all(in, out);
    std::fclose(in);
    return good;
}

void run(const octets& input, const char* name, bool mutated) {
    current_name = name;
    current_input = &input;
    current_is_mutated = mutated;
    (void)LLVMFuzzerTestOneInput(input.data(), input.size());
    current_name = nullptr;
}

bool is_folder(const std::string& path) {
    struct stat about {};
    return ::stat(path.c_str(), &about) == 0 && S_ISDIR(about.st_mode);
}

/// `path`, or if it is a folder the files under it, in a fixed order.
std::vector<std::string> files_under(const std::string& path) {
    std::vector<std::string> files, left{path};
    while (!left.empty()) {
        const std::string next = left.back();
        left.pop_back();
        if (!is_folder(next)) {
            files.push_back(next);
            continue;
        }
        DIR* folder = ::opendir(next.c_str());
        if (folder == nullptr) continue;
        while (const dirent* entry = ::readdir(folder))
            if (entry->d_name[0] != '.') left.push_back(next + "/" + entry->d_name);
        ::closedir(folder);
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool take_number(std::string_view argument, std::string_view name, auto& out) {
    if (!argument.starts_with(name)) return false;
    const long long value = std::strtoll(std::string(argument.substr(name.size())).c_str(), nullptr, 10);
    out = static_cast<std::remove_reference_t<decltype(out)>>(value < 0 ? 0 : value);
    return true;
}

options parse(int argc, char** argv) {
    options o;
    for (int i = 1; i != argc; ++i) {
        const std::string_view a = argv[i];
        constexpr std::string_view prefix = "-artifact_prefix=";
        if (a == "--wire") o.print_wire = true;
        else if (a == "--census") o.census = true;
        else if (a.starts_with(prefix)) o.failing_input = std::string(a.substr(prefix.size())) + "crash-input";
        else if (take_number(a, "-runs=", o.runs) || take_number(a, "-seed=", o.seed) || take_number(a, "-max_len=", o.max_len)) continue;
        else if (a.size() > 1 && a[0] == '-') std::fprintf(stderr, "%s: a flag of libFuzzer, ignored here\n", argv[i]);
        else o.paths.emplace_back(a);
    }
    return o;
}

/// One new input: mostly one input mutated, now and then two crossed.
octets next_input(const std::vector<octets>& corpus, std::size_t max_len, std::minstd_rand& rng) {
    octets input = corpus.empty() ? octets{} : corpus[rng() % corpus.size()];
    std::size_t size = std::min(input.size(), max_len);
    input.resize(max_len);
    if (LLVMFuzzerCustomCrossOver != nullptr && !corpus.empty() && rng() % 8 == 0) {
        const octets& other = corpus[rng() % corpus.size()];
        const octets copy(input.begin(), input.begin() + static_cast<std::ptrdiff_t>(size));
        size = LLVMFuzzerCustomCrossOver(copy.data(), copy.size(), other.data(), other.size(), input.data(), max_len, static_cast<unsigned>(rng()));
    }
    for (auto turns = rng() % 4 + 1; turns != 0; --turns)
        size = LLVMFuzzerCustomMutator != nullptr ? LLVMFuzzerCustomMutator(input.data(), size, max_len, static_cast<unsigned>(rng()))
                                                  : LLVMFuzzerMutate(input.data(), size, max_len);
    input.resize(size);
    return input;
}

}  // namespace

/// What libFuzzer gives to custom mutators; here a handful of plain mutations.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
    static std::minstd_rand rng(1);
    const std::size_t at = size == 0 ? 0 : rng() % size;
    const auto octet = static_cast<std::uint8_t>(rng());
    switch (rng() % 5) {
        case 0: if (size != 0) data[at] ^= static_cast<std::uint8_t>(1U << octet % 8); break;
        case 1: if (size != 0) data[at] = octet; break;
        case 2:
            if (size < max_size) {
                std::memmove(data + at + 1, data + at, size - at);
                data[at] = octet;
                return size + 1;
            }
            break;
        case 3:
            if (size > 1) {
                std::memmove(data + at, data + at + 1, size - at - 1);
                return size - 1;
            }
            break;
        default:
            if (size != 0) {
                const std::size_t from = rng() % size, n = std::min(rng() % 16 + 1, size - std::max(from, at));
                std::memmove(data + at, data + from, n);
            }
    }
    return size == 0 && max_size != 0 ? (data[0] = octet, std::size_t{1}) : size;
}

/// Replays everything named on the command line; false when something could not be read.
static bool replay(const options& o, std::vector<octets>& corpus) {
    for (const std::string& path : o.paths)
        for (const std::string& file : files_under(path)) {
            if (!read_file(file, corpus.emplace_back())) {
                std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
                return false;
            }
            if (!o.print_wire) run(corpus.back(), file.c_str(), false);
            else if (trama_fuzz_print_wire != nullptr) trama_fuzz_print_wire(corpus.back().data(), corpus.back().size());
        }
    return true;
}

int main(int argc, char** argv) {
    const options o = parse(argc, argv);
    failing_path = o.failing_input;
    for (const int number : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP}) std::signal(number, on_signal);
    if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(on_death);

    std::vector<octets> corpus;
    if (argc == 1) {
        octets input;
        if (!read_all(stdin, input)) return 1;
        run(input, "standard input", false);
        return 0;
    }
    if (!replay(o, corpus)) return 1;
    if (corpus.empty() && o.runs == 0) {
        std::fprintf(stderr, "no input found, nothing was run\n");
        return 1;
    }
    std::minstd_rand rng(o.seed);
    for (std::size_t i = 0; i != o.runs; ++i) run(next_input(corpus, o.max_len, rng), "a mutated input", true);
    if (o.census && trama_fuzz_census != nullptr) trama_fuzz_census();
    if (!o.print_wire) std::fprintf(stderr, "%zu inputs replayed, %zu mutated ones tried\n", corpus.size(), o.runs);
    return 0;
}
