#pragma once
// Where the members of the objects in a line of JSON are, for mutations; the line need not be JSON.
#include <algorithm>
#include <string_view>
#include <vector>

namespace trama::fuzz {

/// `"key": value` in a line: the key's first quote, its last, where the value begins and ends.
struct member {
    std::size_t begin = 0, key_end = 0, value = 0, end = 0;

    std::string_view key_in(std::string_view line) const { return line.substr(begin, key_end - begin); }
    std::string_view value_in(std::string_view line) const { return line.substr(value, end - value); }
};

/// Behind the string whose first quote stands at `at`.
inline std::size_t behind_string(std::string_view line, std::size_t at) {
    for (++at; at < line.size() && line[at] != '"'; ++at)
        if (line[at] == '\\') ++at;
    return std::min(at + 1, line.size());
}

/// Behind the value that begins at `at`.
inline std::size_t behind_value(std::string_view line, std::size_t at) {
    for (int depth = 0; at < line.size();) {
        const char c = line[at];
        if (c == '"') {
            at = behind_string(line, at);
            continue;
        }
        if (depth == 0 && (c == ',' || c == '}' || c == ']')) break;
        depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
        ++at;
    }
    return at;
}

/// Those of nested objects too.
inline std::vector<member> members_of(std::string_view line) {
    std::vector<member> found;
    for (std::size_t at = line.find('"'); at < line.size(); at = line.find('"', at)) {
        member m{at, behind_string(line, at), 0, 0};
        at = std::min(line.find_first_not_of(" \t", m.key_end), line.size());
        if (at == line.size() || line[at] != ':') continue;
        m.value = ++at;
        m.end = behind_value(line, at);
        found.push_back(m);
    }
    return found;
}

}  // namespace trama::fuzz
