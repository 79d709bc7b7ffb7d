#include "rtcore/platform/raw_memory.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rtcore {

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20U;
constexpr std::size_t kWorthLargePages = 2 * kLargePage;

} // namespace

void* allocateRaw(std::size_t bytes) {
    const bool large = bytes >= kWorthLargePages;
    const std::size_t alignment = large ? kLargePage : 16;
    const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
    if (whole < bytes) throw std::bad_alloc();
    void* const memory = std::aligned_alloc(alignment, whole > 0 ? whole : alignment);
    if (memory == nullptr) throw std::bad_alloc();
    preferLargePages(memory, whole);
    return memory;
}

void preferLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t kPage = 4096;
    if (bytes < kWorthLargePages) return;
    const auto from = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (from + kPage - 1) / kPage * kPage;
    // Advice: without it all works the same, only slower.
    madvise(reinterpret_cast<void*>(first), (from + bytes) / kPage * kPage - first, MADV_HUGEPAGE);
#endif
}

void touchPages(void* memory, std::size_t bytes) {
    constexpr std::size_t kPage = 4096;
    [[maybe_unused]] constexpr std::size_t kWorthThreads = std::size_t{64} << 20U;
    auto* const first = static_cast<volatile unsigned char*>(memory);
#pragma omp parallel for schedule(static) if (bytes > kWorthThreads)
    for (std::size_t at = 0; at < bytes; at += kPage) first[at] = 0;
}

void freeRaw(void* memory) { std::free(memory); }

void returnFreedMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace rtcore
