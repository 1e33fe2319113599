#include <atomic>
#include <cstdlib>
#include <new>

#include "laws/counting_allocator.hpp"

namespace {
std::atomic<std::size_t> calls{0};
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
// Under a sanitizer, which clang announces in another way, these belong to its run-time; operator new counts everywhere.
extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* old, std::size_t size) noexcept;
void* malloc(std::size_t size) noexcept { ++calls; return __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) noexcept { ++calls; return __libc_calloc(count, size); }
void* realloc(void* old, std::size_t size) noexcept { ++calls; return __libc_realloc(old, size); }
}
#endif

void* operator new(std::size_t size) {
    ++calls;
    if (void* p = std::malloc(size != 0 ? size : 1)) return p;
    throw std::bad_alloc{};
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++calls;
    return std::malloc(size != 0 ? size : 1);
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept { return operator new(size, tag); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }

namespace trama::test {

std::size_t allocations() noexcept { return calls; }

}  // namespace trama::test
