#include "rtcore/motion/key_bindings.h"

#include <algorithm>
#include <iterator>

namespace rtcore {

namespace {

constexpr auto kDefaults = [] {
    constexpr std::array<KeyBinding, 22> kMoves = {{
        {'W', Action::Forward},
        {'S', Action::Back},
        {'A', Action::Left},
        {'D', Action::Right},
        {'I', Action::Up},
        {'O', Action::Down},
        {KeyUp, Action::Forward},
        {KeyDown, Action::Back},
        {KeyLeft, Action::Left},
        {KeyRight, Action::Right},
        {KeyUp, Action::TurnUp, KeyCapsLock},
        {KeyDown, Action::TurnDown, KeyCapsLock},
        {KeyLeft, Action::TurnLeft, KeyCapsLock},
        {KeyRight, Action::TurnRight, KeyCapsLock},
        {KeyPageUp, Action::Up},
        {KeyPageDown, Action::Down},
        {KeySpace, Action::Jump},
        {'C', Action::Crouch},
        {KeyControl, Action::Crawl},
        {KeyShift, Action::Sprint},
        {'F', Action::ToggleWalk},
        {'B', Action::ToggleBloom},
    }};
    std::array<KeyBinding, 42> all{};
    std::size_t n = 0;
    for (const KeyBinding& move : kMoves) all[n++] = move;
    for (int digit = 0; digit < 10; ++digit) {
        const int number = digit == 0 ? 10 : digit;
        all[n++] = {'0' + digit, Action::ToggleLight, KeyNone, number};
        all[n++] = {'0' + digit, Action::SelectEnvironment, 'M', number};
    }
    return all;
}();

bool isKey(int key) { return key > 0 && key < kKeyCodes; }
bool isDown(const KeyBindings::Down& down, int key) { return down[static_cast<std::size_t>(key)]; }

} // namespace

std::span<const KeyBinding> defaultKeyBindings() { return kDefaults; }

KeyBindings::KeyBindings(std::span<const KeyBinding> bindings) {
    std::copy_if(bindings.begin(), bindings.end(), std::back_inserter(bindings_),
                 [](const KeyBinding& b) { return isKey(b.key) && (b.with == KeyNone || isKey(b.with)); });
}

bool KeyBindings::fits(const KeyBinding& binding, const Down& down) const {
    if (binding.with != KeyNone) return isDown(down, binding.with);
    return std::none_of(bindings_.begin(), bindings_.end(), [&](const KeyBinding& other) {
        return other.key == binding.key && other.with != KeyNone && isDown(down, other.with);
    });
}

ActionSet KeyBindings::held(const Down& down) const {
    ActionSet set;
    for (const KeyBinding& b : bindings_) {
        if (isHeld(b.action) && isDown(down, b.key) && fits(b, down)) set.set(b.action);
    }
    return set;
}

std::vector<ActionTap> KeyBindings::taps(const Down& down, const Presses& presses, const Down& before,
                                         const Withheld& withheld) const {
    Down since = down | before;
    for (std::size_t key = 0; key < presses.size(); ++key) {
        if (presses[key] > 0) since.set(key);
    }
    std::vector<ActionTap> taps;
    for (const KeyBinding& b : bindings_) {
        const std::uint32_t count = presses[static_cast<std::size_t>(b.key)] - (withheld ? withheld(b) : 0);
        if (count == 0 || !fits(b, since)) continue;
        // An even number of presses of a switch is none; no key is pressed thousands of times between two
        // looks.
        const std::uint32_t times =
            isHeld(b.action) ? (isDown(down, b.key) ? 0U : 1U) : std::min(count, 64U + count % 2);
        taps.insert(taps.end(), times, {b.action, b.number});
    }
    return taps;
}

} // namespace rtcore
