/// Other programs, started and watched.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rtcore {

struct ProcessLimits {
    std::uint64_t memory = 0;   ///< bytes, resident and swapped out; 0 = no limit; looked at every 20 ms
    double silence = 0;         ///< seconds without a byte on its standard output; 0 = no limit
    std::size_t kept = 1 << 18; ///< bytes kept of each output stream; what comes after them is dropped
    const std::atomic<bool>* stop = nullptr; ///< becomes true: kill the program
};

enum class ProcessEnd { Exited, Signalled, MemoryLimit, SilenceLimit, Stopped };

struct ProcessResult {
    ProcessEnd end = ProcessEnd::Exited;
    int code = 0; ///< Exited: the exit code; Signalled: the number of the signal
    std::string output, errors;
    std::uint64_t peakMemory = 0; ///< bytes, the most that was seen by a look every 20 ms
    double seconds = 0;
};

/// Runs `program` with `arguments` (without its own name) and waits until it ends or breaks a limit. It gets
/// no input, none of our open files, default signals, and a process group of its own, which is killed as a
/// whole when a limit is hit, and whose rest is killed when the program ends. Reacts to the end within a
/// millisecond. Leaves no zombie. Safe from many threads, but a program that calls dieWithParent dies with
/// the thread that called this function. Throws FileError: NoInput when there is no such program, TryAgain
/// when resources are short.
ProcessResult runProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const ProcessLimits& limits = {});

/// A program that runs while we feed its standard input: started as runProcess starts one, but with an input,
/// and without limits. For one thread. The destructor kills the program if it still runs.
class PipedProcess {
  public:
    /// `stopped` is asked every 20 ms while we wait for the program; once it says true, the program is killed
    /// and the waiting function throws FileError Stopped. Throws as runProcess does.
    PipedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 std::function<bool()> stopped);
    ~PipedProcess();
    PipedProcess(const PipedProcess&) = delete;
    PipedProcess& operator=(const PipedProcess&) = delete;

    /// Waits until the program has taken all of it. False when it has ended or closed its input; finish()
    /// then tells why.
    bool write(std::span<const std::byte> bytes);
    /// Closes the input and waits for the end. Call it once. The times and the memory are not filled in.
    ProcessResult finish();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Runs `program` in our place: with our standard streams, in our process group, so that the terminal's
/// signals reach it, too. It is killed when we are. `stopSignal` is asked every 20 ms: once it names a signal
/// (0 = none), the program gets that signal unless it ends by itself within a quarter of a second, and is
/// killed after ten. Nothing but the end and the code is filled in. Call it in a process of one thread.
/// Throws as runProcess does.
ProcessResult runForeground(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                            const std::function<int()>& stopSignal);

/// The first executable file of that name in the folders of PATH.
std::optional<std::filesystem::path> findProgram(const std::string& name);

/// A program that only our programs start: beside the running one, else, where it is installed, in
/// ../libexec/rtsuite. The first place when it is in neither.
std::filesystem::path helperProgram(const std::string& name);

/// For the started program, first thing in main: it is killed when `parent` (a processId) ends.
void dieWithParent(std::int64_t parent);
/// For the started program: allocations fail beyond `bytes` of address space. Does nothing under sanitizers,
/// which reserve terabytes.
void limitAddressSpace(std::uint64_t bytes);
void disableCoreDumps();

/// Bytes of memory that this machine has, without swap space.
std::uint64_t machineMemory();

std::int64_t processId();
/// Whether a process of that number runs now; it may be another one than once had the number.
bool processRuns(std::int64_t process);
/// "Segmentation fault" for 11, and so on.
std::string signalName(int signal);

} // namespace rtcore
