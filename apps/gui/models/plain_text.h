/// Text of others - names of files, of parts and of servers, and what messages quote of them - for places of
/// Qt that interpret what they show.
#pragma once

#include <QString>

namespace gui {

/// Without what changes direction or is a control character, as rtcore::printable() spells it; lines stay.
QString plainText(const QString& text);
/// The same for a tool tip, which is markup where it looks like some: there the text is escaped.
QString plainTip(const QString& text);
/// The same for a menu or a button: an '&' is a letter.
QString plainEntry(const QString& text);
/// The same for the title of a window: a "[*]" is no place for the sign of changes.
QString plainTitle(const QString& text);

} // namespace gui
