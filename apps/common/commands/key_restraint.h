/// Actions withheld from the keys of a client; one that serves visitors declares them when it connects.
#pragma once

#include "rtcore/motion/action.h"

#include <cstdint>

namespace app {

/// The numbers of ipc::Client; a higher one includes those below it.
enum class KeyRestraint : std::uint32_t {
    None = 0,
    Bloom = 1, ///< no switching of bloom
    Edits = 2, ///< nothing but moving, and walking or flying
};

/// The least one that withholds it, by whatever key; None: none does.
constexpr KeyRestraint withheldFrom(rtcore::Action action) {
    if (rtcore::isHeld(action) || action == rtcore::Action::ToggleWalk) return KeyRestraint::None;
    return action == rtcore::Action::ToggleBloom ? KeyRestraint::Bloom : KeyRestraint::Edits;
}

} // namespace app
