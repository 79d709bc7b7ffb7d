/// Whether the memory of a command queue is valid. Boost does not check it: pointers, counts, and whether a
/// process waits that must be woken.
#pragma once

#include "ipc/platform/segment.h"

namespace ipc {

/// True for a queue of the agreed dimensions that its maker has finished, whatever messages are in it. Finds
/// accidents; a write between this check and the use of the queue is not found.
bool isSoundQueue(const Segment& memory);

} // namespace ipc
