/// The language of the window's texts.
#pragma once

#include <QString>

namespace gui {

/// "system", "en" or "cs": holds for what is made from now on, texts and the forms of numbers. A language
/// without a translation is English. Once in a process, in the thread of the QApplication, before the first
/// window.
void useLanguage(const QString& name);

} // namespace gui
