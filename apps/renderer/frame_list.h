/// Which frames a run renders, and where each one goes.
#pragma once

#include "renderer/output_names.h"

#include <filesystem>
#include <span>
#include <vector>

namespace renderer {

struct FrameTask {
    int number = 1;
    std::filesystem::path camera; ///< .cam file; empty = the scene's own view
    std::vector<std::filesystem::path> outputs;
};

/// The frames of a list that lie in `range`, numbered by their place in the list from 1.
/// Throws app::UsageError when none does, or when two outputs of a frame have the same name.
std::vector<FrameTask> framesOfList(std::span<const std::filesystem::path> cameras, const FrameRange& range,
                                    std::span<const std::filesystem::path> patterns);

/// The one frame of a run without a list.
FrameTask singleFrame(const std::filesystem::path& camera, std::span<const std::filesystem::path> patterns);

/// Whether all its files are there. They are written atomically, so that a file that exists is complete.
bool isFinished(const FrameTask& frame);

} // namespace renderer
