/// Whether the memory of a command queue makes sense. Boost believes whatever it finds there: pointers,
/// counts, and that somebody waits who must be woken.
#pragma once

#include "ipc/platform/segment.h"

namespace ipc {

/// True for a queue of the agreed dimensions that its maker has finished, whatever messages are in it. Finds
/// accidents; who writes between this look and the use of the queue is not found.
bool isSoundQueue(const Segment& memory);

} // namespace ipc
