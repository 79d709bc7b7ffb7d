#include "rtserver/keyboard.h"

#include "common/key_names.h"

#include <algorithm>

namespace rtserver {

namespace {

namespace key = app::key;

constexpr std::array kBindings{
    Binding{'W', 0, Action::Forward},
    Binding{'S', 0, Action::Back},
    Binding{'A', 0, Action::Left},
    Binding{'D', 0, Action::Right},
    Binding{'I', 0, Action::Up},
    Binding{'O', 0, Action::Down},
    Binding{key::kUp, 0, Action::Forward},
    Binding{key::kDown, 0, Action::Back},
    Binding{key::kLeft, 0, Action::Left},
    Binding{key::kRight, 0, Action::Right},
    Binding{key::kUp, key::kCapsLock, Action::TurnUp},
    Binding{key::kDown, key::kCapsLock, Action::TurnDown},
    Binding{key::kLeft, key::kCapsLock, Action::TurnLeft},
    Binding{key::kRight, key::kCapsLock, Action::TurnRight},
    Binding{key::kShift, 0, Action::Sprint},
};

std::size_t index(int key) { return static_cast<std::size_t>(key); }

} // namespace

std::span<const Binding> defaultBindings() { return kBindings; }

std::bitset<kActions> actionsOf(const std::bitset<ipc::kMaxKeys>& keys, std::span<const Binding> bindings) {
    const auto applies = [&](const Binding& row) {
        return keys[index(row.key)] && (row.with == 0 || keys[index(row.with)]);
    };
    std::bitset<kActions> actions;
    for (const Binding& row : bindings) {
        const bool overruled =
            row.with == 0 && std::any_of(bindings.begin(), bindings.end(), [&](const Binding& other) {
                return other.key == row.key && other.with != 0 && applies(other);
            });
        if (applies(row) && !overruled) actions.set(static_cast<std::size_t>(row.action));
    }
    return actions;
}

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
