#include "tool/options.hpp"

#include <charconv>
#include <string>

#include "tool/output.hpp"

namespace trama::tool {

std::optional<protocol> parse_protocol(std::string_view name) noexcept {
    if (name == "daisy") return protocol::daisy;
    if (name == "can") return protocol::can;
    if (name == "gateway") return protocol::gateway;
    return std::nullopt;
}

options::wish parse_wish(std::string_view word) noexcept {
    if (word == "--help" || word == "-h") return options::wish::help;
    return word == "--version" ? options::wish::version : options::wish::command;
}

namespace {

/// Collects what the arguments say and remembers the first thing that is wrong with them.
class argument_reader {
public:
    argument_reader(std::string_view command, std::span<char*> arguments) : command_(command), left_(arguments) {}

    std::optional<options> read() {
        bool only_operands = false;
        while (!left_.empty() && good_ && found_.asked == options::wish::command) {
            const std::string_view word = left_.front();
            left_ = left_.subspan(1);
            if (!only_operands && word == "--") only_operands = true;
            else if (!only_operands && word.size() > 1 && word.front() == '-') option(word);
            else operand(word);
        }
        if (found_.asked == options::wish::command && good_) check();
        return good_ ? std::optional{found_} : std::nullopt;
    }

private:
    /// Whether what was found goes together.
    void check() {
        if (found_.operands == 0 && command_ != "describe") fail("which protocol: daisy, can or gateway?");
        if (good_ && found_.hex && found_.protocol == protocol::can) fail("--hex does not go with can, whose logs are text");
        if (good_ && timeout_given_ && found_.protocol != protocol::can) fail("--timeout is for can only");
        if (good_ && (found_.ranged || found_.jobs > 1)) parts();
    }
    void fail(std::string_view what, std::string_view detail = {}) {
        complain(command_, ": ", what, detail, " (see trama --help)");
        good_ = false;
    }
    void operand(std::string_view word) {
        if (found_.operands == 0) {
            if (const auto p = parse_protocol(word)) found_.protocol = *p;
            else fail("unknown protocol ", word);
        } else if (found_.operands == 1) {
            (command_ == "describe" ? found_.message : found_.file) = word;
        } else {
            fail(command_ == "describe" ? "more than one message: " : "more than one file: ", word);
        }
        ++found_.operands;
    }
    void option(std::string_view word) {
        const std::size_t equals = word.find('=');
        const std::string_view name = word.substr(0, equals);
        if (found_.asked = parse_wish(word); found_.asked != options::wish::command) return;
        if (name == "--hex" && equals == word.npos && command_ != "describe") found_.hex = true;
        else if (name == "--unchecked" && equals == word.npos && command_ == "encode") found_.unchecked = true;
        else if (name == "--format" && command_ == "decode") format(value(name, word, equals));
        else if (name == "--timeout" && command_ == "decode") timeout(value(name, word, equals));
        else if (name == "--jobs" && command_ == "decode") jobs(value(name, word, equals));
        else if (name == "--range" && command_ == "decode") range(value(name, word, equals));
        else fail("unknown option ", word);
    }
    static bool number(std::string_view digits, auto& n) {
        const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), n);
        return !digits.empty() && end.ec == std::errc{} && end.ptr == digits.data() + digits.size();
    }
    void jobs(std::string_view count) {
        if (good_ && (!number(count, found_.jobs) || found_.jobs == 0 || found_.jobs > 1024)) fail("--jobs takes a number from 1 to 1024, not ", count);
    }
    void range(std::string_view bounds) {
        const std::size_t colon = bounds.find(':');
        found_.ranged = true;
        const bool good = colon != bounds.npos && number(bounds.substr(0, colon), found_.from) && number(bounds.substr(colon + 1), found_.to);
        if (good_ && (!good || found_.from > found_.to)) fail("--range takes FROM:TO in bytes, such as 0:1000000, not ", bounds);
    }
    /// Whether a file can be decoded in parts.
    void parts() {
        if (found_.file == "-") fail("--jobs and --range need a file");
        else if (found_.hex) fail("--jobs and --range do not go with --hex");
        else if (found_.ranged && found_.jobs > 1) fail("--jobs does not go with --range");
        else if (found_.ranged && found_.protocol == protocol::can) fail("--range is for daisy and gateway");
    }
    std::string_view value(std::string_view name, std::string_view word, std::size_t equals) {
        if (equals != word.npos) return word.substr(equals + 1);
        if (left_.empty()) { fail("a value is missing after ", name); return {}; }
        const std::string_view next = left_.front();
        left_ = left_.subspan(1);
        return next;
    }
    void format(std::string_view name) {
        if (!good_) return;
        found_.text = name == "text";
        if (name != "text" && name != "json") fail("--format is json or text, not ", name);
    }
    void timeout(std::string_view seconds) {
        if (!good_) return;
        const auto t = parse_seconds(seconds);
        if (!t) return fail("--timeout takes seconds, such as 0.5, up to " + std::to_string(most_seconds) + ", not ", seconds);
        found_.timeout = *t;
        timeout_given_ = true;
    }

    std::string_view command_;
    std::span<char*> left_;
    options found_{};
    bool timeout_given_ = false;
    bool good_ = true;
};

}  // namespace

std::optional<options> parse_options(std::string_view command, std::span<char*> arguments) {
    return argument_reader(command, arguments).read();
}

}  // namespace trama::tool
