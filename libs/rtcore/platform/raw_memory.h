/// Memory for long lists, which is not cleared first.
#pragma once

#include <cstddef>

namespace rtcore {

/// Memory for `bytes`, aligned to 16 bytes at least, in large pages where the system has them and it is worth
/// it: a long list is then read without misses of the translation buffer, and is ready after fewer page
/// faults. Pages that are never written cost nothing. Safe from any thread. Throws std::bad_alloc.
void* allocateRaw(std::size_t bytes);
/// Null does nothing.
void freeRaw(void* memory);

/// Asks for large pages for memory that is allocated and not yet written. Without them, or for little
/// memory, it does nothing.
void preferLargePages(void* memory, std::size_t bytes);

/// Writes into each page of memory that holds nothing yet, by the threads of OpenMP if it is much.
void touchPages(void* memory, std::size_t bytes);

/// Gives the system back what was freed and what the allocator keeps for later, as far as it can (glibc).
/// Takes a while after much was freed: for a moment in which nothing else is to be done. Safe from any
/// thread.
void returnFreedMemory();

} // namespace rtcore
