#pragma once
// counting_allocator.cpp replaces the allocating functions of the program it is linked into.

#include <cstddef>

namespace trama::test {

/// Calls of malloc, calloc, realloc and operator new so far.
std::size_t allocations() noexcept;

}  // namespace trama::test
