#include "ipc/endpoint/server.h"

#include "ipc/channel/sequenced_value.h"
#include "ipc/channel/shared_copy.h"
#include "ipc/endpoint/publication.h"
#include "ipc/endpoint/served_client.h"
#include "ipc/endpoint/server_lock.h"
#include "ipc/platform/fault_point.h"
#include "ipc/platform/rules.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <utility>

namespace ipc {

namespace {

constexpr auto kTurnSlice = std::chrono::milliseconds(10);
constexpr auto kSweepEvery = std::chrono::milliseconds(50);
constexpr auto kHousekeepingEvery = std::chrono::seconds(1);
constexpr int kCommandsPerTurn = 16;

std::size_t checkedBytes(std::uint32_t width, std::uint32_t height) {
    const std::size_t bytes = pixelBytes({.width = width, .height = height});
    if (bytes == 0) {
        throw Error(Problem::TooLarge, "a frame has 1 to {0} pixels a side, not {1} x {2}",
                    {std::to_string(kMaxFrameSide), std::to_string(width), std::to_string(height)});
    }
    return bytes;
}

std::uint32_t checkedSlots(std::uint32_t slots) { return std::clamp(slots, kMinFrameSlots, kMaxFrameSlots); }

} // namespace

struct Server::State {
    explicit State(const ServerOptions& options)
        : names(options.instance), slots(checkedSlots(options.frameSlots)), process(processId()) {
        const std::size_t frameBytes = checkedBytes(options.width, options.height);
        Segment control = claimControl(names, sizeof(ControlBlock), Clock::now() + options.patience);
        faultPoint("server locked");
        if (keeps("a new server removes what was left")) removeSegments(names);
        faultPoint("names cleared");
        publication = std::make_unique<Publication>(names, std::move(control), frameBytes, slots, 1);
    }

    ControlBlock& block() const { return publication->block(); }
    void beat() const { block().pulse.alive.fetch_add(1, std::memory_order_relaxed); }

    bool lookAtSlots();
    void sweep();
    void repair();
    void housekeep();
    void lookAfterNames();
    void removeLeftQueues() const;
    void publishAnew();

    Names names;
    std::uint32_t slots;
    std::int64_t process;
    std::unique_ptr<Publication> publication;
    std::array<ServedClient, kMaxClients> clients;
    std::vector<Command> backlog; ///< taken, not yet handed out
    Clock::time_point lastSweep, lastHousekeeping;
    FrameInfo begun;
    bool drawing = false;
    std::uint64_t shown = 0; ///< number of the last frame
    Status status;
};

bool Server::State::lookAtSlots() {
    bool changed = false;
    for (int i = 0; i < kMaxClients; ++i) {
        changed |= clients[static_cast<std::size_t>(i)].look(i, block().clients[i], names,
                                                             publication->epoch(), backlog);
    }
    return changed;
}

void Server::State::sweep() {
    const Clock::time_point now = Clock::now();
    if (now - lastSweep >= kSweepEvery) {
        lastSweep = now;
        for (int i = 0; i < kMaxClients; ++i) {
            const ServedClient& client = clients[static_cast<std::size_t>(i)];
            const bool dead = client.active() && !publication->slotLocked(i);
            if (dead && keeps("dead clients lose their slots")) {
                ServedClient::declareDead(block().clients[i], client.tag());
            }
        }
        if (keeps("fields are repaired")) repair();
    }
    if (now - lastHousekeeping >= kHousekeepingEvery && !drawing) {
        lastHousekeeping = now;
        housekeep();
    }
}

// Restores fields that a buggy client wrote over, before other clients read them for long.
void Server::State::repair() {
    publication->repair();
    for (int i = 0; i < kMaxClients; ++i) clients[static_cast<std::size_t>(i)].repair(block().clients[i]);
    Sequenced<Status>& shared = block().status;
    const bool whole = shared.sequence.load(std::memory_order_relaxed) % 2 == 0;
    if (!whole || std::memcmp(&shared.value, &status, sizeof status) != 0) write(shared, status);
}

// Only another server ends this one. Whatever else fails is tried again in a second.
void Server::State::housekeep() {
    try {
        removeLeftQueues();
        lookAfterNames();
    } catch (const Error& error) {
        if (error.problem == Problem::AlreadyRunning) throw;
    } catch (const std::bad_alloc&) {
        return;
    }
}

// A queue is made by the client that has locked the slot. One seen before the lock was found free has no
// owner.
void Server::State::removeLeftQueues() const {
    for (const std::string& name : segmentNames(names.prefix() + "q")) {
        const int slot = names.slotOfQueue(name);
        if (slot >= 0 && !publication->slotLocked(slot)) Segment::remove(name);
    }
}

void Server::State::lookAfterNames() {
    if (!publication->named() && keeps("lost names are given again")) publishAnew();
    if (!publication->framesNamed()) publication->replaceFrames(publication->frames().capacity());
}

// Clients find the new control segment as they would find another server's. On failure the old one serves on,
// for those who have it.
void Server::State::publishAnew() {
    std::optional<Segment> control = tryClaimControl(names, sizeof(ControlBlock));
    if (!control) return refuseRival(names);
    lookAtSlots();
    for (int i = 0; i < kMaxClients; ++i) {
        ServedClient& client = clients[static_cast<std::size_t>(i)];
        if (client.active()) client.leave(block().clients[i], publication->epoch(), backlog);
    }
    auto next = std::make_unique<Publication>(names, std::move(*control), publication->frames().capacity(),
                                              slots, std::max<std::uint64_t>(1, shown));
    next->takeLastFrame(publication->frameMemory());
    write(next->block().status, status);
    publication->end(ServerPhase::Replaced);
    publication = std::move(next);
}

Server::Server(const ServerOptions& options) : state_(std::make_unique<State>(options)) {}

Server::~Server() {
    // A child that was forked has the object, but not the right to remove anything.
    if (processId() != state_->process) {
        (void)state_->publication.release();
    } else {
        state_->removeLeftQueues();
    }
}

std::uint64_t Server::epoch() const { return state_->publication->epoch(); }

bool Server::wait(std::chrono::nanoseconds timeout) {
    State& state = *state_;
    const Clock::time_point deadline = Clock::now() + timeout;
    while (true) {
        state.beat();
        state.sweep();
        if (state.lookAtSlots() || !state.backlog.empty()) return true;
        const Clock::time_point now = Clock::now();
        const Clock::time_point slice = std::min(deadline, now + kTurnSlice);
        if (waitUntil(state.block().bell, slice)) return true;
        // Before the slice was over: a signal.
        if (const auto then = Clock::now(); then >= deadline || then < slice) return false;
    }
}

std::vector<Command> Server::takeCommands(const ClientSet& later) {
    State& state = *state_;
    state.beat();
    state.sweep();
    state.lookAtSlots();
    for (int i = 0; i < kMaxClients; ++i) {
        ServedClient& client = state.clients[static_cast<std::size_t>(i)];
        if (client.active() && !later[static_cast<std::size_t>(i)]) {
            client.serve(state.block().clients[i], state.publication->epoch(), kCommandsPerTurn,
                         state.backlog);
        }
    }
    return std::exchange(state.backlog, {});
}

void Server::answer(const Command& command, std::string_view text, std::string_view detail) {
    reply(command, {0, 0, std::string(text), std::string(detail)});
}

void Server::refuse(const Command& command, int code, std::string_view text, std::string_view detail) {
    constexpr int kMax = 255;
    reply(command,
          {0, static_cast<std::uint16_t>(std::clamp(code, 1, kMax)), std::string(text), std::string(detail)});
}

void Server::reply(const Command& command, ReplyRecord record) {
    if (command.slot < 0 || command.slot >= kMaxClients) return;
    faultPoint("before answer");
    ClientSlot& slot = state_->block().clients[command.slot];
    state_->clients[static_cast<std::size_t>(command.slot)].answer(slot, command, std::move(record));
}

bool Server::isConnected(const Command& command) const {
    if (command.slot < 0 || command.slot >= kMaxClients) return false;
    const ServedClient& client = state_->clients[static_cast<std::size_t>(command.slot)];
    return client.active() && client.tag() == command.client;
}

KeyState Server::keys() {
    KeyState keys;
    for (int i = 0; i < kMaxClients; ++i) {
        ServedClient& client = state_->clients[static_cast<std::size_t>(i)];
        if (client.active()) client.collectKeys(state_->block().clients[i], keys);
    }
    return keys;
}

int Server::clients() const {
    return static_cast<int>(std::count_if(state_->clients.begin(), state_->clients.end(),
                                          [](const ServedClient& client) { return client.active(); }));
}

std::uint64_t Server::malformed() const {
    std::uint64_t sum = 0;
    for (const ServedClient& client : state_->clients) sum += client.malformed();
    return sum;
}

void Server::reserveFrame(std::uint32_t width, std::uint32_t height) {
    State& state = *state_;
    const std::size_t bytes = checkedBytes(width, height);
    if (bytes <= state.publication->frames().capacity()) return;
    state.drawing = false;
    state.publication->replaceFrames(bytes);
}

std::span<std::byte> Server::beginFrame(std::uint32_t width, std::uint32_t height) {
    State& state = *state_;
    reserveFrame(width, height);
    const std::size_t bytes = checkedBytes(width, height);
    state.begun = {.width = width, .height = height};
    state.drawing = true;
    return state.publication->frames().begin().first(bytes);
}

std::uint64_t Server::publishFrame(const FrameInfo& info) {
    State& state = *state_;
    if (!state.drawing) return state.shown;
    FrameInfo frame = info;
    frame.width = state.begun.width;
    frame.height = state.begun.height;
    frame.nanoseconds = std::chrono::nanoseconds(Clock::now().time_since_epoch()).count();
    state.shown = state.publication->frames().nextNumber();
    state.publication->frames().publish(frame);
    state.drawing = false;
    state.block().pulse.progress.fetch_add(1, std::memory_order_relaxed);
    for (int i = 0; i < kMaxClients; ++i) {
        ClientSlot& slot = state.block().clients[i];
        const bool asks = slot.wantsFrames.load(std::memory_order_relaxed) != 0;
        if (asks && state.clients[static_cast<std::size_t>(i)].active()) ring(slot.bell);
    }
    return state.shown;
}

std::uint64_t Server::publishFrame(const FrameInfo& info, std::span<const std::byte> pixels) {
    const std::span<std::byte> target = beginFrame(info.width, info.height);
    copyToShared(target.data(), pixels.data(), std::min(target.size(), pixels.size()));
    return publishFrame(info);
}

void Server::setStatus(const Status& status) {
    state_->status = status;
    write(state_->block().status, status);
}

} // namespace ipc
