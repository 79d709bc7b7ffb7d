// The only file of the window that calls the operating system.
#include "gui/processes/detach.h"

#include <QProcess>

#include <unistd.h>

namespace gui {

void startDetached(QProcess& process) {
    process.setChildProcessModifier([] { ::setsid(); });
}

} // namespace gui
