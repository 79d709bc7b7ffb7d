/// Processes that may outlive the window.
#pragma once

class QProcess;

namespace gui {

/// Before start(): the process gets a session of its own, so that Ctrl-C in the window's terminal is not
/// meant for it.
void startDetached(QProcess& process);

} // namespace gui
