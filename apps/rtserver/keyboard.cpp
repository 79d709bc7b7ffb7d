#include "rtserver/keyboard.h"

namespace rtserver {

namespace {

std::size_t index(int key) { return static_cast<std::size_t>(key); }

} // namespace

void Keyboard::press(int key) {
    if (!down_[index(key)]) ++presses_[index(key)];
    down_.set(index(key));
}

void Keyboard::release(int key) { down_.reset(index(key)); }

void Keyboard::tap(int key) {
    ++presses_[index(key)];
    down_.reset(index(key));
}

void Keyboard::collect(ipc::KeyState& state) {
    state.down |= down_;
    for (std::size_t i = 0; i < presses_.size(); ++i) state.presses[i] += presses_[i];
    presses_.fill(0);
}

} // namespace rtserver
