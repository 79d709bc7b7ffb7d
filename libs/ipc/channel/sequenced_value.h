/// Writing and reading a Sequenced value.
#pragma once

#include "ipc/channel/shared_copy.h"
#include "ipc/layout/sequenced.h"
#include "ipc/platform/rules.h"

namespace ipc {

/// One writer at a time. Never waits.
template <class T>
void write(Sequenced<T>& shared, const T& value) {
    const std::uint64_t before = shared.sequence.load(std::memory_order_relaxed) & ~std::uint64_t{1};
    shared.sequence.store(before + 1, std::memory_order_relaxed);
    fenceBeforeWriting();
    copyToShared(&shared.value, &value, sizeof(T));
    shared.sequence.store(before + 2, std::memory_order_release);
}

/// False, and `value` untouched, when the writer was always in between or died there. Never waits.
template <class T>
bool read(const Sequenced<T>& shared, T& value) {
    for (int tries = 0; tries < 64; ++tries) {
        const std::uint64_t before = shared.sequence.load(std::memory_order_acquire);
        if (before % 2 == 1) continue;
        T copy;
        copyFromShared(&copy, &shared.value, sizeof(T));
        fenceAfterReading();
        const bool torn = shared.sequence.load(std::memory_order_relaxed) != before;
        if (torn && keeps("values are checked after they were copied")) continue;
        value = copy;
        return true;
    }
    return false;
}

} // namespace ipc
