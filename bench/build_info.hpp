#pragma once

namespace trama::bench {

extern const char* const build_flags;   ///< Compiler flags of this build.
extern const char* const build_commit;  ///< Commit it was made from, with a + if the tree had changes.

}  // namespace trama::bench
