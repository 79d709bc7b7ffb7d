#include "ipc/endpoint/server_lock.h"

#include "ipc/endpoint/link.h"
#include "ipc/platform/error.h"

#include <thread>

namespace ipc {

namespace {

[[noreturn]] void alreadyRunning(const Names& names, std::int64_t process) {
    const std::string who = process != 0 ? " (process " + std::to_string(process) + ")" : "";
    throw Error(Problem::AlreadyRunning, "server '" + names.instance() + "' is already running" + who +
                                             "; stop it or name another instance");
}

// What cannot even be opened as ours is left to whoever creates the name.
std::optional<ControlFacts> factsByName(const Names& names) {
    try {
        const std::optional<Segment> segment =
            Segment::open(names.control(), Access::Read, sizeof(ControlHeader));
        return segment ? readControlFacts(*segment) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace

OwnerLock takeServerLock(const Names& names, const std::string& folder, Clock::time_point deadline) {
    const std::string path = names.serverLock(folder);
    while (true) {
        if (std::optional<OwnerLock> lock = OwnerLock::tryTake(path)) return std::move(*lock);
        if (Clock::now() >= deadline) alreadyRunning(names, lockHolder(path).process);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

void refuseServerElsewhere(const Names& names, const std::string& folder) {
    const std::optional<ControlFacts> facts = factsByName(names);
    if (!facts || facts->lockFolder == folder) return;
    const LockHolder holder = lockHolder(names.serverLock(facts->lockFolder));
    if (holder.held) alreadyRunning(names, holder.process);
}

int removeSegments(const Names& names) {
    const std::vector<std::string> found = segmentNames(names.prefix());
    for (const std::string& name : found) Segment::remove(name);
    Segment::remove(names.control()); // where segments cannot be listed
    return static_cast<int>(found.size());
}

} // namespace ipc
