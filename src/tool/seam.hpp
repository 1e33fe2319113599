#pragma once

#include <cstdint>
#include <type_traits>

#include "tool/random_file.hpp"
#include "trama/daisy/format.hpp"
#include "trama/gateway/format.hpp"

namespace trama::tool {

template <class F>
inline constexpr bool is_daisy = std::is_same_v<F, daisy::format>;
template <class F>
inline constexpr bool is_gateway = std::is_same_v<F, gateway::format>;

/// A place of a file where one decoder may end and another begin, and where the other has to join for that.
struct seam {
    std::uint64_t join = 0, place = 0;
    std::uint64_t lines = 0;  ///< Of a log, before `place`.
};

/// The first seam at or behind `from`, searched in windows that depend on `from` alone: all who ask find the same.
/// The lines of a log are counted from the seam `before` on. Throws `read_fault`.
template <class F>
seam seam_at(const random_file& file, std::uint64_t from, const seam& before = {});

}  // namespace trama::tool
