/// A process that serves the one that started it, and is of no use without it.
#pragma once

#include <cstdint>

namespace app {

/// From now on the end of the parent, however that ends, asks this process to stop, as SIGTERM does
/// (stop.h). `parent` is the process that started this one, by its own account: if it is not the parent any
/// more, the request comes at once. 0: the parent of this moment, which may be a stranger already if the real
/// one died early. Call it once, after installSignalHandlers(). On Linux SIGUSR2 is used for it.
void stopWithParent(std::int64_t parent);

} // namespace app
