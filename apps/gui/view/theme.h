/// Light, dark, or as the system has it.
#pragma once

class QString;

namespace gui {

/// "light", "dark"; anything else is the system's. Needs a QApplication.
void useTheme(const QString& name);

} // namespace gui
