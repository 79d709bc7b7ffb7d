/// Texts outside of widgets.
#pragma once

#include <QCoreApplication>
#include <QString>

namespace gui {

/// In the user's language.
inline QString tr(const char* text) { return QCoreApplication::translate("gui", text); }

} // namespace gui
