#include "proof.hpp"

#include <algorithm>

namespace trama::bench {

namespace {

std::string words(const std::string& name, const std::string& chunk, const tally& t) {
    return name + (chunk.empty() ? "" : " (" + chunk + ")") + ": " + std::to_string(t.messages) + " messages, sum " + std::to_string(t.sum) + ", errors " +
           std::to_string(t.errors);
}
std::string words(const statement& s) { return words(s.name, s.chunk, s.said); }

bool has_other(const std::vector<statement>& heard, const contender& c) {
    return std::any_of(heard.begin(), heard.end(), [&](const statement& own) {
        return own.name == c.name && own.chunk == c.chunk && std::any_of(heard.begin(), heard.end(), [&](const statement& other) {
                   return other.question == own.question && other.name != own.name;
               });
    });
}

}  // namespace

std::string contradiction(const race& r, const std::vector<statement>& heard) {
    for (const statement& s : heard) {
        const auto first = std::find_if(heard.begin(), heard.end(), [&](const statement& other) { return other.question == s.question; });
        if (!(first->said == s.said)) return s.question + ": " + words(*first) + "\n  but " + words(s);
    }
    for (const contender& c : r.contenders)
        if (c.part != role::limit && !has_other(heard, c)) return c.name + " (" + c.chunk + ") was compared with nobody";
    return {};
}

std::string contradiction(const race& r, const std::vector<statement>& heard, const std::vector<timing>& timed) {
    std::vector<statement> said;
    for (std::size_t i = 0; i != timed.size(); ++i) {
        const contender& c = r.contenders[i];
        if (c.part == role::limit) continue;
        said.push_back({"timed code", c.name, c.chunk, timed[i].result});
        if (!(said.front().said == said.back().said)) return "timed code: " + words(said.front()) + "\n  but " + words(said.back());
        const auto proved = std::find_if(heard.begin(), heard.end(), [&](const statement& s) { return s.name == c.name && s.chunk == c.chunk && s.question == whole_stream; });
        if (proved == heard.end()) return c.name + " (" + c.chunk + ") proved nothing about the stream";
        if (proved->said.messages != said.back().said.messages || proved->said.errors != said.back().said.errors)
            return "proved: " + words(*proved) + "\n  but timed: " + words(said.back());
    }
    return {};
}

}  // namespace trama::bench
