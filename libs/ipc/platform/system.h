/// The only calls of the operating system that Boost does not cover; one source file for each system.
#pragma once

#include "ipc/layout/doorbell.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ipc {

using Clock = std::chrono::steady_clock;

std::uint32_t userId();
std::int64_t processId();

/// The folder of the lock files, made when missing, with mode 0700: $XDG_RUNTIME_DIR/rts, or a folder of this
/// user in the temporary folder. Throws Error NotYours when somebody else made it.
std::string lockFolder();

/// Makes an empty file with mode 0600 unless it is there. Throws Error.
void createPrivateFile(const std::string& path);

/// Tells one file from another that has the same path; {0, 0} when there is none.
struct FileIdentity {
    std::uint64_t device = 0, number = 0;
    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
FileIdentity identityOf(const std::string& path);

/// Who locks a file, without locking it.
struct LockHolder {
    bool held = false;
    std::int64_t process = 0; ///< 0 when it is in a place where its number means nothing here
};
/// Of another process: closing the file here would drop a lock of our own.
LockHolder foreignLockHolder(const std::string& path);

/// What an open segment is.
struct SegmentFacts {
    bool regular = false; ///< a segment, not a folder or a pipe of that name
    bool ours = false;    ///< belongs to this user, and nobody else may read or write it
    std::uint64_t bytes = 0;
    bool named = false; ///< its name still stands
};
SegmentFacts factsOf(int segment);

/// Gives the segment `bytes` of memory that cannot run out later. Throws Error NoSpace with need and rest.
void reserveSpace(int segment, std::size_t bytes, const std::string& name);
/// Throws Error NoSpace when shared memory has less than `bytes` left, as far as one can tell beforehand.
void requireSpace(std::size_t bytes);

/// Names of all segments that begin with `prefix`, whoever made them.
std::vector<std::string> segmentNames(const std::string& prefix);

/// A counter that can be waited on, shared by processes. A process may be killed at any point in these
/// functions without harm to the others.
void initialise(Doorbell& bell);
void ring(Doorbell& bell);
/// True when it was rung since the last call (any number of times counts as one), or as soon as it is; false
/// at `deadline` or when a signal arrived.
bool waitUntil(Doorbell& bell, Clock::time_point deadline);

} // namespace ipc
