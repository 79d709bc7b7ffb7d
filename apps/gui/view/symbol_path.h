/// Line drawings as SVG writes them, as paths of Qt: the icons of the bridge's page, which the window shares.
#pragma once

#include <QPainterPath>
#include <QString>

namespace gui {

constexpr int kSymbolSide = 24; ///< of the square that symbols are drawn in

/// The path of the `d` of a <path>: moves, lines, cubic curves and unrotated arcs, absolute and relative.
/// Ends where anything else begins.
QPainterPath pathOf(const QString& drawing);

/// The paths and circles of the symbol "i-NAME" in the page; empty when it has none.
QPainterPath symbolPath(const QString& name);

} // namespace gui
