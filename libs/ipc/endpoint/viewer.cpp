#include "ipc/endpoint/viewer.h"

#include "ipc/channel/sequenced_value.h"
#include "ipc/endpoint/frame_feed.h"
#include "ipc/endpoint/open_link.h"

#include <thread>

namespace ipc {

struct Viewer::State {
    explicit State(const std::string& instance) : names(instance), feed(names) {}
    Names names;
    std::optional<Link> link;
    FrameFeed feed;
    Status status;
    Clock::time_point lastLook;
};

Viewer::Viewer(const std::string& instance, std::chrono::nanoseconds patience)
    : state_(std::make_unique<State>(instance)) {
    state_->link.emplace(openLink(state_->names, Access::Read, Clock::now() + patience));
}

Viewer::~Viewer() = default;

LinkState Viewer::update() {
    State& state = *state_;
    const LinkState now = state.link->check();
    if (now != LinkState::Gone || Clock::now() - state.lastLook < kLookEvery) return now;
    state.lastLook = Clock::now();
    std::optional<Link> next = state.link->successor(Access::Read);
    if (!next) return LinkState::Gone;
    state.link = std::move(next);
    return LinkState::Connected;
}

std::uint64_t Viewer::epoch() const { return state_->link->epoch(); }
std::int64_t Viewer::serverProcess() const { return state_->link->serverProcess(); }

bool Viewer::readFrame(Frame& frame) {
    update();
    return state_->feed.read(*state_->link, frame);
}

bool Viewer::waitForFrame(Frame& frame, std::chrono::nanoseconds timeout) {
    const Clock::time_point deadline = Clock::now() + timeout;
    while (!readFrame(frame)) {
        if (Clock::now() >= deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

Status Viewer::status() {
    update();
    read(state_->link->block().status, state_->status);
    return state_->status;
}

} // namespace ipc
