#include "rtserver/walk/keyboard.h"

#include <algorithm>

namespace rtserver {

namespace {

std::size_t index(int key) { return static_cast<std::size_t>(key); }

} // namespace

void Keyboard::press(int key) {
    if (!down_[index(key)]) ++presses_[index(key)];
    down_.set(index(key));
    std::erase_if(timed_, [key](const TimedPress& press) { return press.key == key; });
}

std::uint64_t Keyboard::pressFor(int key, std::chrono::nanoseconds time) {
    press(key);
    timed_.push_back({key, ++number_, time, false});
    return number_;
}

void Keyboard::release(int key) {
    down_.reset(index(key));
    std::erase_if(timed_, [key](const TimedPress& press) { return press.key == key; });
}

void Keyboard::endPress(std::uint64_t number) {
    std::erase_if(timed_, [&](const TimedPress& press) {
        if (press.number != number) return false;
        down_.reset(index(press.key));
        return true;
    });
}

void Keyboard::releaseAll() {
    down_.reset();
    timed_.clear();
}

void Keyboard::tap(int key) {
    ++presses_[index(key)];
    release(key);
}

bool Keyboard::advance(std::chrono::nanoseconds time) {
    const std::size_t before = timed_.size();
    for (TimedPress& press : timed_) {
        if (press.collected) press.left -= time;
        if (press.left.count() <= 0) down_.reset(index(press.key));
    }
    std::erase_if(timed_, [](const TimedPress& press) { return press.left.count() <= 0; });
    return timed_.size() != before;
}

std::chrono::nanoseconds Keyboard::untilRelease() const {
    auto until = std::chrono::nanoseconds::max();
    for (const TimedPress& press : timed_) {
        if (press.collected) until = std::min(until, press.left);
    }
    return until;
}

bool Keyboard::isDown(std::uint64_t number) const {
    return std::any_of(timed_.begin(), timed_.end(),
                       [number](const TimedPress& press) { return press.number == number; });
}

void Keyboard::collect(ipc::KeyState& state) {
    state.down |= down_;
    for (std::size_t i = 0; i < presses_.size(); ++i) state.presses[i] += presses_[i];
    presses_.fill(0);
    for (TimedPress& press : timed_) press.collected = true;
}

} // namespace rtserver
