#include "bridge/control/locked_keys.h"

#include "rtcore/motion/action.h"
#include "rtcore/motion/key_codes.h"

#include <sstream>
#include <string>
#include <vector>

namespace bridge {

bool LockedKeys::isLocked(std::string_view name) const {
    const std::optional<rtcore::Action> action = rtcore::actionNamed(name);
    const app::KeyRestraint min = action ? app::withheldFrom(*action) : app::KeyRestraint::Edits;
    return min != app::KeyRestraint::None && restraint() >= min;
}

void LockedKeys::read(std::string_view bindings) {
    locked_.emplace();
    std::istringstream lines{std::string(bindings)};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string key, action;
        words >> key >> action;
        if (const std::size_t with = key.find('+', 1); with != std::string::npos) key.erase(0, with + 1);
        const std::optional<int> code = rtcore::keyNamed(key);
        if (code && isLocked(action)) locked_->set(static_cast<std::size_t>(*code));
    }
}

InputMessage LockedKeys::allowed(InputMessage input) const {
    if (!possible()) return input;
    const auto remove = [&](std::vector<std::uint8_t>& keys) {
        std::erase_if(keys, [&](std::uint8_t key) { return !locked_ || locked_->test(key); });
    };
    remove(input.held);
    remove(input.taps);
    return input;
}

} // namespace bridge
