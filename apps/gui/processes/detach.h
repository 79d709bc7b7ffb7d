/// What a process that the window starts is to be beside a child: independent, or modest.
#pragma once

class QProcess;

namespace gui {

/// Before start(): the process gets a session of its own, so that Ctrl-C in the window's terminal is not
/// meant for it.
void startDetached(QProcess& process);

/// Before start(): the process works with what others leave it of the processors, as live pictures come
/// first.
void startModestly(QProcess& process);

} // namespace gui
