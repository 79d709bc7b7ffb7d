#include "gui/models/at_rest.h"

#include "gui/models/preferences.h"

#include <QComboBox>
#include <QCoreApplication>

namespace gui {

AtRest atRest(const Preferences& preferences) {
    if (!preferences.get(pref::progressiveRendering)) return AtRest::Live;
    return preferences.get(pref::globalIllumination) ? AtRest::Global : AtRest::Refined;
}

void setAtRest(Preferences& preferences, AtRest what) {
    if (what != AtRest::Live) preferences.set(pref::globalIllumination, what == AtRest::Global);
    preferences.set(pref::progressiveRendering, what != AtRest::Live);
}

void toggleAtRest(Preferences& preferences, AtRest what) {
    if (atRest(preferences) != what) return setAtRest(preferences, what);
    if (what == AtRest::Live) return preferences.set(pref::progressiveRendering, true);
    if (what == AtRest::Global) setAtRest(preferences, AtRest::Refined);
}

QString atRestText(AtRest what) {
    switch (what) {
    case AtRest::Live:
        return QCoreApplication::translate("gui", "Live frame");
    case AtRest::Refined:
        return QCoreApplication::translate("gui", "Refined");
    case AtRest::Global:
        break;
    }
    return QCoreApplication::translate("gui", "Global illumination");
}

void fillAtRest(QComboBox& box) {
    for (const AtRest each : kAtRest) box.addItem(atRestText(each));
}

} // namespace gui
