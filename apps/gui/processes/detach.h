/// Processes that may outlive the window, or stand back behind it.
#pragma once

class QProcess;

namespace gui {

/// Before start(): the process gets a session of its own, so that Ctrl-C in the window's terminal is not
/// meant for it. It tells its sentences for programs, too (printed_lines.h), as does the next one.
void startDetached(QProcess& process);

/// Before start(): the process leaves the processor to what the user looks at.
void startInBackground(QProcess& process);

} // namespace gui
