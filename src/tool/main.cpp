#include <csignal>
#include <span>
#include <string_view>

#include <unistd.h>

#include "tool/decode.hpp"
#include "tool/describe.hpp"
#include "tool/encode.hpp"
#include "tool/options.hpp"
#include "tool/output.hpp"

namespace {

constexpr std::string_view help =
    R"(trama: three wire formats, from bytes to meaning and back

  trama decode daisy|can|gateway [--hex] [--format json|text] [--timeout SECONDS]
               [--jobs N] [--range FROM:TO] [FILE]
        Prints what FILE holds, one JSON object a line. daisy and gateway are raw bytes,
        can is a candump log. Without FILE, or with -, standard input is read.
          --hex              the input is hex digits in pairs (daisy, gateway)
          --format text      for people instead of programs
          --timeout SECONDS  how long a multi-frame message may stall, by the log's own
                             time (can; 1 by default)
          --jobs N           on N cores if there are so many, with the same output; needs
                             a regular file
          --range FROM:TO    only what begins in these bytes of the file, each bound moved
                             to the next footing: the output of ranges that follow each
                             other, put together, is that of the whole, unless one says that
                             the part behind it may not fit (daisy, gateway)

  trama encode daisy|can|gateway [--hex] [--unchecked] [FILE]
        Reads JSON lines as decode prints them and writes raw bytes or candump log lines.
          --hex              writes each packet as a line of hex digits (daisy, gateway)
          --unchecked        writes values too that the protocol does not allow

  trama describe [PROTOCOL [MESSAGE]]
        Shows the wire layout: offset, size, name, type, range, meaning.

  trama --help | --version

Exit status: 0 all well; 1 some of the input was in error or had values that the
protocol does not allow; 2 usage or I/O error.
)";

int show(trama::tool::options::wish asked) {
    using namespace trama::tool;
    output out(STDOUT_FILENO);
    out.write(asked == options::wish::version ? "trama " TRAMA_VERSION "\n" : help);
    out.flush();
    return all_well;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace trama::tool;
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is seen as EPIPE
    std::signal(SIGXFSZ, SIG_IGN);  // and a file that may not grow as EFBIG
    const std::span<char*> words(argv, static_cast<std::size_t>(argc));
    const std::string_view command = words.size() > 1 ? words[1] : "";
    if (const auto asked = parse_wish(command); asked != options::wish::command) return show(asked);
    if (command == "decode" || command == "encode" || command == "describe") {
        const auto o = parse_options(command, words.subspan(2));
        if (!o) return failed;
        if (o->asked != options::wish::command) return show(o->asked);
        return command == "decode" ? decode(*o) : command == "encode" ? encode(*o) : describe(*o);
    }
    if (command.empty()) complain("nothing to do; see trama --help");
    else complain("unknown command ", command, "; see trama --help");
    return failed;
}
