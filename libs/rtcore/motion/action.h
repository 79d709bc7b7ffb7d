/// Actions that keys trigger, and the set of those that are on at a moment.
#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

namespace rtcore {

enum class Action {
    Forward,
    Back,
    Left,
    Right,
    Up,   ///< viewing mode only
    Down, ///< viewing mode only
    TurnLeft,
    TurnRight,
    TurnUp,
    TurnDown,
    Jump,
    Crouch, ///< viewing mode: slowly
    Crawl,
    Sprint,
    // Acts once for each press, on more than the player.
    ToggleWalk,
    ToggleBloom,
    ToggleLight,       ///< with the light's number
    SelectEnvironment, ///< with the environment's number
};
inline constexpr std::size_t kActions = 18;

/// True for what goes on while a key is down; false for what happens once for each press.
constexpr bool isHeld(Action action) { return action < Action::ToggleWalk; }

/// True for what acts on one of several, by its number.
constexpr bool hasNumber(Action action) {
    return action == Action::ToggleLight || action == Action::SelectEnvironment;
}

/// As in the settings of keys: "forward", "turnLeft".
std::string_view actionName(Action action);
std::optional<Action> actionNamed(std::string_view name);

class ActionSet {
  public:
    bool has(Action a) const { return bits_[static_cast<std::size_t>(a)]; }
    void set(Action a, bool on = true) { bits_[static_cast<std::size_t>(a)] = on; }
    bool none() const { return bits_.none(); }
    friend ActionSet operator|(ActionSet a, const ActionSet& b) {
        a.bits_ |= b.bits_;
        return a;
    }
    friend bool operator==(const ActionSet&, const ActionSet&) = default;
    /// 1, 0 or -1: what two opposite actions come to.
    double balance(Action plus, Action minus) const {
        return (has(plus) ? 1.0 : 0.0) - (has(minus) ? 1.0 : 0.0);
    }

  private:
    std::bitset<kActions> bits_;
};

} // namespace rtcore
