/// Processes without the terminal that started them, or behind what the user looks at.
#pragma once

#include "common/process/exit_codes.h"

#include <cstdint>
#include <optional>

namespace app {

/// Before any thread is started, and once. In a child process, which has a session of its own: returns
/// nothing. In the parent: waits until the child called detach() and returns Done, or until it ended, and
/// returns its exit code; passes a stop signal on to it. Throws std::runtime_error.
std::optional<ExitCode> goToBackground();

/// In the child: the parent may end now; standard streams lead nowhere from here on, and the current folder
/// is the root.
void detach();

/// This process gets a session of its own, so that Ctrl-C in the terminal is not meant for it.
/// Async-signal-safe: a child may call it between fork and exec.
void startSession() noexcept;

/// This process leaves the processor to others, unless RT_KEEP_PRIORITY is set: tests that wait for such work
/// would else wait for all that runs beside them. Async-signal-safe as well.
void lowerPriority() noexcept;
/// The same for another process, which has started no threads yet.
void lowerPriorityOf(std::int64_t process) noexcept;

} // namespace app
