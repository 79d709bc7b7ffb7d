#include "rtcore/platform/raw_memory.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
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
#ifdef MADV_HUGEPAGE
    // Advice: without it all works the same, only slower.
    if (large) madvise(memory, whole, MADV_HUGEPAGE);
#endif
    return memory;
}

void freeRaw(void* memory) { std::free(memory); }

} // namespace rtcore
