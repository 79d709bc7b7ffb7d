#include "ipc/endpoint/instances.h"

#include "ipc/endpoint/link.h"
#include "ipc/endpoint/server_lock.h"

#include <algorithm>
#include <iterator>
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

int clientsOf(const Names& names) {
    const std::optional<Segment> segment = Segment::open(names.control(), Access::Read, sizeof(ControlBlock));
    const std::optional<ControlFacts> facts = segment ? readControlFacts(*segment) : std::nullopt;
    if (!facts || facts->handshake != ownHandshake()) return 0;
    const ControlBlock& block = *static_cast<const ControlBlock*>(segment->data());
    return static_cast<int>(
        std::count_if(std::begin(block.slots), std::end(block.slots), [](const ClientSlot& slot) {
            return slot.servedTag.load(std::memory_order_acquire) != 0;
        }));
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
            instances.push_back({name, holder.held, holder.process, holder.held ? clientsOf(names) : 0});
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
