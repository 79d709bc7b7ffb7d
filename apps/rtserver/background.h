/// A program that goes on without the terminal that started it.
#pragma once

#include "common/process/exit_codes.h"

#include <optional>

namespace rtserver {

/// Before any thread is started. In a child process, which has a session of its own: returns nothing. In the
/// parent: waits until the child called detach() and returns Done, or until it ended, and returns its exit
/// code; passes a stop signal on to it. Throws std::runtime_error.
std::optional<app::ExitCode> goToBackground();

/// In the child: the parent may end now; standard streams lead nowhere from here on.
void detach();

} // namespace rtserver
