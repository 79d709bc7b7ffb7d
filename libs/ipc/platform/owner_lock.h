/// Proof that the owner of a name lives: a locked file. The system unlocks it when the process ends, however
/// it ends, once its memory is torn down. Not inherited by children.
#pragma once

#include "ipc/platform/system.h"

#include <memory>
#include <optional>
#include <string>

namespace ipc {

class OwnerLock {
  public:
    /// Nothing when somebody - another process or another object of this one - holds it. Makes the file when
    /// missing and never removes it: a name that comes and goes could have two owners. Throws Error System.
    /// Any thread.
    static std::optional<OwnerLock> tryTake(const std::string& path);

    OwnerLock(OwnerLock&&) noexcept;
    OwnerLock& operator=(OwnerLock&&) noexcept;
    ~OwnerLock();

    /// False when the locked file was removed: somebody may lock another file of that name.
    bool stands() const;

  private:
    struct State;
    explicit OwnerLock(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Who holds the lock now, this process included; does not take it. Any thread.
LockHolder lockHolder(const std::string& path);

} // namespace ipc
