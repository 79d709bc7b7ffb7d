/// The standard streams, and this process, as the operating system sees them.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace app {

/// Columns of the terminal behind stderr, at least 20; nothing when stderr is no terminal.
std::optional<int> terminalColumns();

/// Writes all of it to the stream at once, unbuffered. writeOutput throws rtcore::FileError: CannotWrite (a
/// full disk, a closed pipe), Stopped when a signal comes while the output is not read; writeError ignores
/// failures, there is no place left to report them.
void writeOutput(std::string_view bytes);
/// The same for lines that hold names from files: where a terminal would obey control characters in them, it
/// gets `\xNN`, all but tabs and line ends. Programs get the text as it is.
void writeLines(std::string_view lines);
void writeError(std::string_view text) noexcept;

/// Whether a message of up to 4096 bytes would be written without waiting: false while the reader of the
/// stream does not, and a pipe is full or a terminal stopped.
bool outputTakesMore() noexcept;
bool errorTakesMore() noexcept;

/// The most memory that this process has held so far.
std::uint64_t peakMemoryBytes() noexcept;

/// Bytes that came on standard input, into `bytes`: an empty text where none came in time, nothing once the
/// input has ended. One thread.
std::optional<std::string_view> readInput(std::span<char> bytes, std::chrono::milliseconds patience) noexcept;

} // namespace app
