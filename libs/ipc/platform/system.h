/// The only calls of the operating system that Boost does not cover; one source file for each system.
#pragma once

#include "ipc/layout/doorbell.h"
#include "ipc/platform/rules.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ipc {

/// Unlike the wall clock it is never set.
struct Clock : std::chrono::steady_clock {
    static time_point now() noexcept {
        if (keeps("waits go by the steady clock")) return steady_clock::now();
        return time_point(std::chrono::system_clock::now().time_since_epoch());
    }
};

std::uint32_t userId();
/// As that of rtcore/platform: neither library knows the other.
std::int64_t processId();

/// Opens a segment without waiting, whatever lies at its name: -1 when there is none. Throws
/// Error: NotYours when it is a link or may not be opened, System.
int openSegment(const std::string& name, bool writing);
void closeSegment(int segment);
/// Throws Error NotYours when that cannot be done.
void renameSegment(const std::string& from, const std::string& to);

/// A lock on one byte of a segment, whether it has that byte or not. The system drops it when the process
/// that took it ends, however it ends, once its memory is torn down. It belongs to the descriptor (and to its
/// maps, and those of children that were forked without exec): nothing is lost by closing another descriptor
/// of the segment, nor by removing its name. False when another descriptor, of this process or another, has
/// it. Throws Error System.
bool tryLockByte(int segment, std::uint64_t byte);
void unlockByte(int segment, std::uint64_t byte);
/// Whether another descriptor has it; true, too, when the system cannot tell: no process is taken for dead
/// because of an error.
bool isByteLocked(int segment, std::uint64_t byte);

/// Facts about an open segment.
struct SegmentFacts {
    bool regular = false; ///< a segment, not a folder or a pipe of that name
    bool ours = false;    ///< belongs to this user, and no other may read or write it
    std::uint64_t bytes = 0;
    bool named = false; ///< its name still stands
};
SegmentFacts factsOf(int segment);

/// Gives the segment `bytes` of memory that cannot run out later. Throws Error NoSpace with need and rest.
void reserveSpace(int segment, std::size_t bytes, const std::string& name);
/// Throws Error NoSpace when shared memory has less than `bytes` left, as far as one can tell beforehand.
void requireSpace(std::size_t bytes);

/// Names of all segments of this user that begin with `prefix`.
std::vector<std::string> segmentNames(const std::string& prefix);

/// A process may be killed at any point in these functions without harm to the others. A foreign write to a
/// bell causes a spurious wake-up, or a ring that is noticed at the deadline only.
void ring(Doorbell& bell);
/// True when it was rung since the last call (any number of times counts as one), or as soon as it is; false
/// at `deadline` or when a signal arrived.
bool waitUntil(Doorbell& bell, Clock::time_point deadline);

} // namespace ipc
