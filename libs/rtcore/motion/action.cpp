#include "rtcore/motion/action.h"

#include <array>

namespace rtcore {

namespace {

constexpr std::array<std::string_view, kActions> kActionNames = {
    "forward",  "back",      "left",       "right",       "up",          "down",
    "turnLeft", "turnRight", "turnUp",     "turnDown",    "jump",        "crouch",
    "crawl",    "sprint",    "toggleWalk", "toggleBloom", "toggleLight", "selectEnvironment"};

} // namespace

std::string_view actionName(Action action) { return kActionNames[static_cast<std::size_t>(action)]; }

std::optional<Action> actionNamed(std::string_view name) {
    for (std::size_t i = 0; i < kActionNames.size(); ++i) {
        if (kActionNames[i] == name) return static_cast<Action>(i);
    }
    return std::nullopt;
}

} // namespace rtcore
