# Writes OUT, a source file with the flags and the commit of this build; run at every build, changes only what changed.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git -C ${SOURCE} status --porcelain -uno -- include src bench OUTPUT_VARIABLE changes ERROR_QUIET)
if(NOT commit)
    set(commit unknown)
elseif(changes)
    string(APPEND commit "+")
endif()
string(STRIP "${FLAGS}" FLAGS)
file(CONFIGURE OUTPUT ${OUT} CONTENT [[#include "build_info.hpp"

namespace trama::bench {

const char* const build_flags = "@FLAGS@";
const char* const build_commit = "@commit@";

}  // namespace trama::bench
]] @ONLY)
