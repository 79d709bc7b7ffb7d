/// Which key does what, as data.
#pragma once

#include "rtcore/motion/action.h"
#include "rtcore/motion/key_codes.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rtcore {

struct KeyBinding {
    int key = KeyNone;
    Action action = Action::Forward;
    int with = KeyNone; ///< another key that must be down too; KeyNone: none
    int number = 0;     ///< of the light or environment

    friend bool operator==(const KeyBinding&, const KeyBinding&) = default;
};

/// One press of a key that acts once.
struct ActionTap {
    Action action = Action::Forward;
    int number = 0;
    friend bool operator==(const ActionTap&, const ActionTap&) = default;
};

/// WASD, I/O and the arrows move, with CapsLock the arrows turn; F walks or flies; digits switch lights (1
/// the first, 0 the tenth), with M environments; B bloom; C crouch, Control crawl, Space jump, Shift sprint.
std::span<const KeyBinding> defaultKeyBindings();

/// Turns the state of a keyboard into actions. Where two bindings of a key fit, only the one with a second
/// key acts. Several keys may do the same. Keys beyond 0..255 never act. Immutable; safe from many threads.
class KeyBindings {
  public:
    using Down = std::bitset<kKeyCodes>;
    using Presses = std::array<std::uint32_t, kKeyCodes>;

    explicit KeyBindings(std::span<const KeyBinding> bindings = defaultKeyBindings());

    std::span<const KeyBinding> list() const { return bindings_; }

    /// The actions that go on while these keys are down.
    ActionSet held(const Down& down) const;
    /// The taps by the presses since the last look, in the order of the bindings; of actions that are held,
    /// one for each key that is up again, so that the shortest press moves. `before`: the keys that were down
    /// at the last look. A key that was down at any time since then counts as held with those that were
    /// pressed. `withheld`: how many of a binding's presses are to have no effect.
    using Withheld = std::function<std::uint32_t(const KeyBinding&)>;
    std::vector<ActionTap> taps(const Down& down, const Presses& presses, const Down& before = {},
                                const Withheld& withheld = {}) const;

  private:
    bool fits(const KeyBinding& binding, const Down& down) const;
    std::vector<KeyBinding> bindings_;
};

} // namespace rtcore
