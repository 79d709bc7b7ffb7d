/// The right to be the server of an instance.
#pragma once

#include "ipc/platform/names.h"
#include "ipc/platform/owner_lock.h"

namespace ipc {

/// Tries until `deadline` (a killed server is alive until its memory is torn down). Throws Error
/// AlreadyRunning.
OwnerLock takeServerLock(const Names& names, const std::string& folder, Clock::time_point deadline);

/// A server may hold its lock in another folder than ours, when its environment is another.
/// Throws Error AlreadyRunning then.
void refuseServerElsewhere(const Names& names, const std::string& folder);

/// All names of the instance. Only for who holds its lock. Returns how many there were.
int removeSegments(const Names& names);

} // namespace ipc
