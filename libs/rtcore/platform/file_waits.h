/// The behaviour of this process at files that would make it wait: pipes, terminals, devices.
#pragma once

namespace rtcore {

/// While one of the functions of files.h waits for such a file, `stopped` is asked every 20 ms; once it says
/// true, that function throws FileError Stopped. Null, the default: never. Safe from any thread,
/// and `stopped` is called from any.
void interruptFilesBy(bool (*stopped)() noexcept);

/// From now on the functions of files.h read and write nothing but regular files, so that no path can make
/// them wait; anything else is refused at once (NoInput, CannotWrite). For programs that serve others.
/// A file system that does not answer still makes them wait.
void allowRegularFilesOnly();

} // namespace rtcore
