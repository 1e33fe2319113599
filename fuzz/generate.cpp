// Writes seed corpora and dictionaries from the golden vectors and the schema: fuzz_generate [--check] FOLDER. With --check it writes nothing and
// says what FOLDER holds that differs, so that CI notices when the schema has moved on.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "golden/vectors.hpp"
#include "mutate.hpp"
#include "mutate_body.hpp"
#include "text.hpp"

namespace {

namespace fs = std::filesystem;
using namespace trama;
using namespace trama::fuzz;

/// All files to be, by their path under the folder.
using files = std::map<std::string, std::string>;

std::string as_text(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

/// Octets as a dictionary entry.
std::string dictionary_entry(std::string_view token) {
    std::string out = "\"";
    for (const char c : token) {
        char text[8];
        std::snprintf(text, sizeof text, c >= 0x20 && c <= 0x7E && c != '"' && c != '\\' ? "%c" : "\\x%02X", static_cast<unsigned char>(c));
        out += text;
    }
    return out + "\"\n";
}

/// A name that tells requests from replies and is fit for a file.
template <wire_format F, class M>
std::string file_name() {
    std::string name{M::name};
    std::replace(name.begin(), name.end(), '.', '-');
    if constexpr (std::is_same_v<F, daisy::format>)
        if ((daisy::command_of(M::key) & daisy::response_bit) != 0) name += "-reply";
    return name;
}

template <wire_format F>
std::string json_of(std::span<const typename F::unit> units) {
    std::string lines;
    typename F::decoder decoder;
    read<F>(decoder, units, [&](const typename F::event& e) { lines += line_of<F>(e) + "\n"; });
    return lines;
}

/// Where `M` stands in the list.
template <class M, class... All>
std::uint8_t place(message_list<All...>) {
    std::uint8_t i = 0;
    (void)((std::is_same_v<M, All> || (++i, false)) || ...);
    return i;
}

/// A packet and its body for `decode`, as seeds called `name`.
template <wire_format F, class M>
void add_seed(files& all, const std::string& name, std::uint8_t choice, std::span<const typename F::unit> units, const M& m) {
    const std::string folder = "corpus/" + std::string(F::name);
    all[folder + "/" + name] = as_text(traits<F>::octets_from(units));
    all[folder + "_decode/" + name] = as_text(as_input(choice, m));
}

/// Of every message one packet with a value that the document does not allow, where the wire can carry one.
template <wire_format F>
void add_strange(files& all) {
    std::uint32_t seed = 1;
    std::uint8_t choice = 0;  // of the message, in input for decode
    F::messages::each([&]<class M>() {
        const std::uint8_t own = choice++;
        if (M::layout.count == 0) return;
        for (int tries = 0; tries != 1000; ++tries) {
            dice d(++seed);
            arena memory;
            M m = random_message<M>(d, memory);
            change_one_value(m, d, memory);
            std::array<typename F::unit, F::max_units> wire{};
            const auto size = F::encode_unchecked(traits<F>::template envelope_for<M>(d), m, wire);
            if (!size || is_valid(m)) continue;
            add_seed<F>(all, file_name<F, M>() + "-strange", own, std::span<const typename F::unit>(wire).first(*size), m);
            break;
        }
    });
}

/// All golden vectors, those of one message numbered.
void add_golden(files& all) {
    std::map<std::string, int> numbers;
    golden::each_vector([&]<class Row>(const Row& row) {
        using F = typename Row::format;
        using M = typename Row::message;
        const std::string name = file_name<F, M>(), format{F::name};
        const std::string numbered = name + "-" + std::to_string(++numbers[format + name]);
        add_seed<F>(all, numbered, place<M>(typename F::messages{}), row.units(), row.value);
        all["corpus/" + format + "_text/" + numbered] = json_of<F>(row.units());
    });
}

/// A log with a node that answers, one that does not, and frames of every kind.
void add_log(files& all) {
    all["corpus/can_text/log"] =
        "(0.000000) can0 081#020452\n(0.010000) can0 081#0204520400640102\n(0.020000) can0 082#010741\n(0.030000) can0 081#02045204006401F0\n"
        "(1.500000) vcan0 080#0A0943140B04010C\n(1.500001) vcan0 080#141E\n(2.0) can1 00000081#0102\n(2.1) can1 081#R8\n(2.2) can1 081##1020304\n";
}

/// Scripts for the sessions: what happens in them has no golden vectors, so that bytes at random have to do.
void add_scripts(files& all) {
    for (const char* format : {"daisy", "can", "gateway"})
        for (std::uint32_t n = 1; n != 9; ++n) {
            dice d(n);
            std::string script(64 * n, '\0');
            for (char& c : script) c = static_cast<char>(d.below(256));
            all["corpus/" + std::string(format) + "_session/script-" + std::to_string(n)] = script;
        }
}

/// Every name in the schema of `M`: fields, nested fields, enumerators.
template <has_layout M>
void collect_names(std::set<std::string>& names_seen) {
    each_index<M>([&]<std::size_t I>() {
        using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
        names_seen.insert("\"" + std::string(field_of<M, I>.name) + "\":");
        const auto value = [&]<class V>() {
            if constexpr (has_layout<V>) collect_names<V>(names_seen);
            else if constexpr (enumerated<V>)
                for (const auto& e : names(V{})) names_seen.insert("\"" + std::string(e.name) + "\"");
        };
        if constexpr (requires { typename one::value::value_type; }) value.template operator()<typename one::value::value_type>();
        else value.template operator()<typename one::value>();
    });
}

/// How the golden vectors begin: as the medium delivers them, or as input for `decode`.
template <wire_format F>
std::set<std::string> beginnings(const files& all, std::string_view folder) {
    constexpr std::size_t length = std::is_same_v<F, can::format> ? 5 : 4;
    std::set<std::string> tokens;
    const std::string path = "corpus/" + std::string(F::name) + std::string(folder) + "/";
    for (auto at = all.lower_bound(path); at != all.end() && at->first.starts_with(path); ++at)
        if (!at->first.ends_with("-strange")) tokens.insert(at->second.substr(0, length));
    return tokens;
}

template <wire_format F>
void add_dictionaries(files& all) {
    const std::string format{F::name};
    std::string wire = "# Made by fuzz_generate from the golden vectors: how each message begins.\n";
    for (const auto& token : beginnings<F>(all, "")) wire += dictionary_entry(token);
    if constexpr (std::is_same_v<F, gateway::format>) wire += dictionary_entry("\x03") + dictionary_entry("\x03\x02") + dictionary_entry("     ") + dictionary_entry("  0");
    all["dict/" + format + ".dict"] = wire;
    std::string bodies = "# Made by fuzz_generate from the golden vectors: the choice of a message and how its body begins.\n";
    for (const auto& token : beginnings<F>(all, "_decode")) bodies += dictionary_entry(token);
    all["dict/" + format + "_decode.dict"] = bodies;

    std::set<std::string> words{"{\"protocol\":\"" + format + "\"", "\"message\":\"", "\"fields\":{", "\"violations\":[", "\"error\":\"", "\\u00e9", "\\u0000", "\\ud800", "null", "true", "-1", "1e3", "0.5", "}}"};
    F::messages::each([&]<class M>() {
        words.insert("\"" + std::string(M::name) + "\"");
        collect_names<M>(words);
    });
    if constexpr (std::is_same_v<F, daisy::format>) words.insert({"\"destination\":", "\"source\":", "\"kind\":\"response\"", "\"kind\":\"request\"", "\"offset\":", "\"length\":"});
    if constexpr (std::is_same_v<F, can::format>) words.insert({"\"id\":129", "\"line\":", "\"frames\":", "(0.000000) can0 081#", "##1", "#R"});
    std::string json = "# Made by fuzz_generate from the schema: the words of its JSON.\n";
    for (const auto& word : words) json += dictionary_entry(word);
    all["dict/" + format + "_text.dict"] = json;
}

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Differences between what `folder` holds and what it should hold.
int check(const fs::path& folder, const files& all) {
    int differences = 0;
    const auto tell = [&](const std::string& path, const char* what) {
        std::fprintf(stderr, "%s: %s\n", path.c_str(), what);
        ++differences;
    };
    for (const auto& [path, text] : all)
        if (!fs::exists(folder / path)) tell(path, "is missing");
        else if (content(folder / path) != text) tell(path, "is not what schema and golden vectors say");
    for (const char* part : {"corpus", "dict"}) {
        if (!fs::exists(folder / part)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(folder / part)) {
            const std::string path = fs::relative(entry.path(), folder).generic_string();
            if (entry.is_regular_file() && !all.contains(path)) tell(path, "is not made from them");
        }
    }
    if (differences != 0) std::fprintf(stderr, "run fuzz_generate on the folder fuzz/ and commit what it changes\n");
    return differences == 0 ? 0 : 1;
}

/// False when the files could not be written, said on standard error.
bool write(const fs::path& folder, const files& all) {
    fs::remove_all(folder / "corpus");
    fs::remove_all(folder / "dict");
    for (const auto& [path, text] : all) {
        fs::create_directories((folder / path).parent_path());
        std::ofstream file(folder / path, std::ios::binary);
        file << text;
        file.close();
        if (file) continue;
        std::fprintf(stderr, "fuzz_generate: cannot write %s\n", (folder / path).c_str());
        return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const bool checking = argc == 3 && std::string_view(argv[1]) == "--check";
    if (argc != 2 && !checking) {
        std::fprintf(stderr, "usage: fuzz_generate [--check] FOLDER\n");
        return 2;
    }
    if (const fs::path folder = argv[argc - 1]; !checking && (fs::exists(folder / "corpus") || fs::exists(folder / "dict")) && !fs::exists(folder / "dict/can_decode.dict")) {
        std::fprintf(stderr, "fuzz_generate: %s holds a corpus or dict that is not its own; give it fuzz/ or a new folder\n", argv[argc - 1]);
        return 2;
    }
    files all;
    add_golden(all);
    add_strange<daisy::format>(all);
    add_strange<can::format>(all);
    add_strange<gateway::format>(all);
    add_log(all);
    add_scripts(all);
    add_dictionaries<daisy::format>(all);
    add_dictionaries<can::format>(all);
    add_dictionaries<gateway::format>(all);
    if (checking) return check(argv[2], all);
    return write(argv[1], all) ? 0 : 2;
}

// The mutators that come along with the harness are not used here.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) { return size; }
