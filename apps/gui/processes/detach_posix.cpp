// The only file of the window that calls the operating system.
#include "gui/processes/detach.h"

#include <QProcess>

#include <unistd.h>

namespace gui {

void startDetached(QProcess& process) {
    process.setChildProcessModifier([] { ::setsid(); });
}

void startInBackground(QProcess& process) {
    constexpr int kStep = 10;
    process.setChildProcessModifier([] { static_cast<void>(!::nice(kStep)); });
}

} // namespace gui
