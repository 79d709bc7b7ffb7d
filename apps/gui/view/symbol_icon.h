/// Icons of lines in the colour that letters have at the moment, so that they suit light and dark windows.
#pragma once

#include <QIcon>
#include <QString>

namespace gui {

/// The icon of the symbol of that name (symbolPath()); dim while its action is disabled.
QIcon symbolIcon(const QString& name);

} // namespace gui
