/// The image that the window shows when the camera rests, as one choice; stored as the two preferences that
/// it replaces.
#pragma once

#include <array>

class QComboBox;
class QString;

namespace gui {

class Preferences;

enum class AtRest {
    Live,    ///< the frame of the server
    Refined, ///< that in higher quality
    Global,  ///< with all light, also from surface to surface
};

inline constexpr std::array kAtRest{AtRest::Live, AtRest::Refined, AtRest::Global};

AtRest atRest(const Preferences& preferences);
/// Live keeps how it is rendered when it is asked for.
void setAtRest(Preferences& preferences, AtRest what);
/// Changes to `what`; where it is that already, to what it stands in place of: the way of a key.
void toggleAtRest(Preferences& preferences, AtRest what);

QString atRestText(AtRest what);
/// With the three, in their order.
void fillAtRest(QComboBox& box);

} // namespace gui
