/// Keys and mouse actions in the image, besides the bindings of keys: for F1 and docs/window.md.
#pragma once

#include "gui/models/mouse_scheme.h"

#include <QList>
#include <QString>

namespace gui {

struct ViewKey {
    QString keys, meaning; ///< in the window's language
};

QList<ViewKey> viewKeys(MouseScheme scheme = MouseScheme::Usual);

} // namespace gui
