#include "ipc/endpoint/instances.h"

#include "ipc/endpoint/link.h"
#include "ipc/endpoint/server_lock.h"

#include <set>

namespace ipc {

namespace {

// Another program's lock folder may be another than ours: the control segment tells.
std::string lockFolderOf(const Names& names) {
    try {
        const std::optional<Segment> segment =
            Segment::open(names.control(), Access::Read, sizeof(ControlHeader));
        const std::optional<ControlFacts> facts = segment ? readControlFacts(*segment) : std::nullopt;
        return facts ? facts->lockFolder : lockFolder();
    } catch (const Error&) {
        return lockFolder();
    }
}

} // namespace

std::vector<Instance> listInstances() {
    std::set<std::string> found;
    const std::string prefix = userPrefix();
    for (const std::string& segment : segmentNames(prefix)) {
        found.insert(segment.substr(prefix.size(), segment.find('.', prefix.size()) - prefix.size()));
    }
    std::vector<Instance> instances;
    for (const std::string& name : found) {
        try {
            const Names names(name);
            const LockHolder holder = lockHolder(names.serverLock(lockFolderOf(names)));
            instances.push_back({name, holder.held, holder.process});
        } catch (const Error&) {
            continue; // not a name of ours
        }
    }
    return instances;
}

int freeInstance(const std::string& name) {
    const Names names(name);
    const std::string folder = lockFolder();
    const OwnerLock lock = takeServerLock(names, folder, Clock::now());
    refuseServerElsewhere(names, folder);
    return removeSegments(names);
}

} // namespace ipc
