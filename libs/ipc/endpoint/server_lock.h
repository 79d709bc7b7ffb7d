/// The right to be the server of an instance: the lock on its control segment, while the name stands for it.
#pragma once

#include "ipc/platform/names.h"
#include "ipc/platform/segment.h"
#include "ipc/platform/system.h"

#include <optional>

namespace ipc {

/// The control segment of the instance: new, zeroed and locked by us. What a dead server left at the name is
/// removed. Nothing while another server has the lock. Throws Error: NotYours when what is there cannot be
/// removed, NoSpace, System.
std::optional<Segment> tryClaimControl(const Names& names, std::size_t bytes);

/// The same, tried until `deadline` (a killed server is alive until its memory is torn down). Throws Error
/// AlreadyRunning, too.
Segment claimControl(const Names& names, std::size_t bytes, Clock::time_point deadline);

/// Throws Error AlreadyRunning when the control segment of that name is complete: then its owner is not just
/// starting, nor just removing the names of a dead server.
void refuseRival(const Names& names);

/// All names of the instance but the control segment's. Only for the holder of the lock.
void removeSegments(const Names& names);

} // namespace ipc
