/// Which servers of this user there are, and the removal of what dead ones left.
#pragma once

#include "ipc/platform/error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ipc {

struct Instance {
    std::string name;
    bool running = false;     ///< false: left by a server that died; free it, or start a server of that name
    std::int64_t process = 0; ///< of the server while it runs
    /// Processes of the clients that it serves now, as they say themselves; viewers are not known to it. One
    /// process may be several clients.
    std::vector<std::int64_t> clients;
};

/// Sorted by name. Any thread.
std::vector<Instance> listInstances();

/// Whether a server may be started under that name: none runs, and nothing of another user is in its way.
bool isAvailable(const std::string& name);

/// `wanted` if that is available, else the first of wanted-2, wanted-3... that is. Any thread; another
/// server may take it meanwhile.
std::string availableName(const std::string& wanted);

/// Removes all shared memory of an instance that has no living server; returns how many names there were.
/// Throws Error: BadName; NotYours; AlreadyRunning, and removes nothing, when its server lives. Any thread.
int freeInstance(const std::string& name);

} // namespace ipc
