/// Waiting for a server to appear.
#pragma once

#include "ipc/endpoint/link.h"

namespace ipc {

/// How often a successor is looked for.
inline constexpr auto kLookEvery = std::chrono::milliseconds(5);

/// Throws Error: NoServer at the deadline; WrongVersion, NotYours at once.
Link openLink(const Names& names, Access access, Clock::time_point deadline);

} // namespace ipc
