#include "ipc/endpoint/instances.h"

#include "ipc/endpoint/link.h"
#include "ipc/endpoint/server_lock.h"

#include <set>

namespace ipc {

namespace {

std::vector<std::int64_t> clientsOf(const Segment& segment, const ControlFacts& facts) {
    std::vector<std::int64_t> processes;
    if (facts.handshake != ownHandshake() || segment.bytes() < sizeof(ControlBlock)) return processes;
    for (const ClientSlot& slot : static_cast<const ControlBlock*>(segment.data())->clients) {
        if (slot.servedTag.load(std::memory_order_acquire) != 0)
            processes.push_back(slot.clientProcess.load(std::memory_order_relaxed));
    }
    return processes;
}

Instance describe(const std::string& name) {
    Instance instance;
    instance.name = name;
    try {
        const std::optional<Segment> segment = Segment::open(Names(name).control(), Access::Read, 0);
        instance.running = segment && serverLives(*segment);
        const std::optional<ControlFacts> facts = segment ? readControlFacts(*segment) : std::nullopt;
        if (!instance.running || !facts) return instance;
        instance.process = facts->serverProcess;
        instance.clients = clientsOf(*segment, *facts);
    } catch (const Error&) {
        return instance; // what cannot be opened is no server
    }
    return instance;
}

bool isInstanceName(const std::string& name) {
    try {
        const Names names(name);
        return true;
    } catch (const Error&) {
        return false;
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
        if (isInstanceName(name)) instances.push_back(describe(name));
    }
    return instances;
}

bool isAvailable(const std::string& name) {
    try {
        const std::optional<Segment> segment = Segment::open(Names(name).control(), Access::Read, 0);
        return !segment || !serverLives(*segment);
    } catch (const Error& error) {
        return error.problem != Problem::NotYours;
    }
}

std::string availableName(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; !isAvailable(name); ++number) name = wanted + "-" + std::to_string(number);
    return name;
}

int freeInstance(const std::string& name) {
    const Names names(name);
    const std::size_t found = segmentNames(names.prefix()).size();
    if (found == 0) return 0;
    const Segment control = claimControl(names, 0, Clock::now());
    removeSegments(names);
    Segment::remove(names.control());
    return static_cast<int>(found);
}

} // namespace ipc
