/// The steps of a walk: which camera was drawn in what detail. Drawn again they give the same frames.
#pragma once

#include "rtcore/scene/camera.h"
#include "rtserver/frames/frame_detail.h"

#include <filesystem>
#include <vector>

namespace bench {

struct WalkStep {
    double seconds = 0; ///< since the walk began, when it was seen
    rtserver::FrameDetail detail = {};
    rtcore::Camera camera = {};
    friend bool operator==(const WalkStep&, const WalkStep&) = default;
};

/// A line of text for each step; numbers come back to the bit. Throws rtcore::FileError.
void writeTrace(const std::filesystem::path& path, const std::vector<WalkStep>& steps);
/// Throws rtcore::FileError, which names the line.
std::vector<WalkStep> readTrace(const std::filesystem::path& path);

} // namespace bench
