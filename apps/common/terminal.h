/// The standard streams, and this process, as the operating system sees them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace app {

/// Columns of the terminal behind stderr, at least 20; nothing when stderr is no terminal.
std::optional<int> terminalColumns();

/// Writes all of it to the stream at once, unbuffered. writeOutput throws rtcore::FileError CannotWrite (a
/// full disk, a closed pipe); writeError ignores failures, there is no place left to report them.
void writeOutput(std::string_view bytes);
void writeError(std::string_view text) noexcept;

/// Whether a message of up to 4096 bytes would be written without waiting: false while whoever reads stderr
/// does not, and a pipe is full or a terminal stopped.
bool errorTakesMore() noexcept;

/// The most memory that this process has held so far.
std::uint64_t peakMemoryBytes() noexcept;

} // namespace app
