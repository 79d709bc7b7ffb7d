/// Images that a Renderer makes while a view rests, one after another, for a program that shows them
/// (docs/protocol.md, "A preview"): its command line and its requests, the same for all such programs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace app {

/// Options of a Renderer that waits for requests and shows its images as this instance. It ends with
/// `parent`, a process.
std::vector<std::string> standByOptions(const std::string& instance, std::int64_t parent);

/// Options of images by paths: exposed anew, since there is more light than in a live frame, whose exposure
/// comes with the camera; filtered from the first sample to the last, so that an image never gets worse.
/// `passes` of the filter, where no net takes the noise; 0: noise stays then.
std::vector<std::string> restingPathOptions(int passes, bool byNet);

/// Passes of the filter unless someone chose others.
inline constexpr int kRestingFilter = 4;

/// A line for the Renderer's input. Paths without tabs and line ends.
std::string standByRequest(std::uint64_t run, const std::string& scene, const std::string& camera);
/// The line by which an image is given up.
inline constexpr const char* kNoRequest = "\n";

} // namespace app
