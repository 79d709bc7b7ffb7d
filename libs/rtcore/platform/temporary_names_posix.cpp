#include "rtcore/platform/temporary_names.h"

#include "rtcore/platform/files.h"

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>

#include <unistd.h>

namespace rtcore {

namespace {

enum class SlotState { Free, Filling, Holding, Removing, Removed };

struct Slot {
    std::atomic<SlotState> state{SlotState::Free};
    pid_t process = 0; ///< a forked child inherits the table but not the files
    TemporaryKind kind = TemporaryKind::File;
    char path[PATH_MAX] = {};
};
static_assert(std::atomic<SlotState>::is_always_lock_free, "used by signal handlers");

constexpr int kSlots = 32;
constinit Slot slots[kSlots];

bool change(Slot& slot, SlotState from, SlotState to) {
    return slot.state.compare_exchange_strong(from, to, std::memory_order_acq_rel);
}

int hold(const std::string& path, TemporaryKind kind) {
    if (path.size() >= PATH_MAX) return -1;
    for (int i = 0; i < kSlots; ++i) {
        Slot& slot = slots[i];
        if (!change(slot, SlotState::Free, SlotState::Filling)) continue;
        std::memcpy(slot.path, path.c_str(), path.size() + 1);
        slot.process = ::getpid();
        slot.kind = kind;
        slot.state.store(SlotState::Holding, std::memory_order_release);
        return i;
    }
    return -1;
}

void removeAll(TemporaryKind kind) {
    for (Slot& slot : slots) {
        if (!change(slot, SlotState::Holding, SlotState::Removing)) continue;
        if (slot.kind != kind) {
            slot.state.store(SlotState::Holding, std::memory_order_release);
            continue;
        }
        const bool ours = slot.process == ::getpid();
        if (ours && kind == TemporaryKind::File) ::unlink(slot.path);
        if (ours && kind == TemporaryKind::Folder) ::rmdir(slot.path);
        slot.state.store(SlotState::Removed, std::memory_order_release);
    }
}

} // namespace

TemporaryName::TemporaryName(const std::string& path, TemporaryKind kind) noexcept
    : slot_(hold(path, kind)) {}

TemporaryName::~TemporaryName() {
    if (slot_ < 0) return;
    Slot& slot = slots[slot_];
    // A handler that is at this slot right now keeps it for good: the process is about to end.
    if (!change(slot, SlotState::Holding, SlotState::Free)) change(slot, SlotState::Removed, SlotState::Free);
}

void removeTemporaryFiles() noexcept {
    const int savedErrno = errno;
    // Folders last: only empty ones can be removed.
    for (const TemporaryKind kind : {TemporaryKind::File, TemporaryKind::Folder}) removeAll(kind);
    errno = savedErrno;
}

} // namespace rtcore
