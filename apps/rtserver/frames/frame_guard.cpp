#include "rtserver/frames/frame_guard.h"

#include <chrono>
#include <utility>

namespace rtserver {

namespace {
constexpr auto kLookEvery = std::chrono::milliseconds(2);
} // namespace

FrameGuard::FrameGuard(std::function<bool()> poll)
    : poll_(std::move(poll)), thread_([this](const std::stop_token& stop) { watch(stop); }) {}

FrameGuard::~FrameGuard() {
    thread_.request_stop();
    thread_.join();
}

void FrameGuard::begin(std::atomic<bool>* cancel) {
    {
        const std::scoped_lock lock(mutex_);
        cancel_ = cancel;
        ++frame_;
    }
    // The end of a frame needs no wake-up: the thread finds out when its interval is over.
    if (cancel != nullptr) wake_.notify_one();
}

void FrameGuard::watch(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return cancel_ != nullptr; })) {
        const std::uint64_t frame = frame_;
        const auto over = [&] { return frame_ != frame; };
        if (wake_.wait_for(lock, stop, kLookEvery, over)) continue;
        while (!stop.stop_requested() && !over()) {
            if (poll_()) *cancel_ = true;
            wake_.wait_for(lock, stop, kLookEvery, over);
        }
    }
}

} // namespace rtserver
