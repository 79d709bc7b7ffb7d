/// How a running program is asked to stop: SIGINT, SIGTERM or SIGHUP set a flag, which long work looks at.
#pragma once

#include "common/process/exit_codes.h"

#include <string>

namespace app {

/// From now on the first such signal sets the flag; a second one removes the temporary files
/// (platform/files.h) and ends the process at once. Signals that the parent ignores (nohup) stay ignored.
/// Calls ignoreWritingSignals(). Standard streams that the parent has closed are filled, so that no file gets
/// their numbers. Waits for pipes and devices end by the flag, too.
void installSignalHandlers();

/// From now on writing to a closed pipe, or beyond the limit of a file's size, is an error like any other:
/// SIGPIPE and SIGXFSZ are ignored.
void ignoreWritingSignals() noexcept;

/// The number of the signal that asked to stop, 0 when none did; SIGTERM also stands for the end of the
/// parent (parent.h). Safe from any thread.
int stopSignal() noexcept;

/// Whether such a signal, or endWork(), asked to stop.
bool stopRequested() noexcept;

/// Asks the work at hand to stop as a signal does, while the program goes on. Any thread.
void endWork() noexcept;
/// Before other work; a signal stays.
void beginWork() noexcept;

/// Throws rtcore::FileError (Stopped) when stopRequested().
void throwIfStopped();

/// 128 + the signal; Interrupted when work was stopped without one.
ExitCode stopExitCode() noexcept;

} // namespace app
