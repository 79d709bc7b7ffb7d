/// Which frames a run renders, and where each one goes.
#pragma once

#include "renderer/output_names.h"

#include "common/cli/input_files.h"

#include <filesystem>
#include <span>
#include <vector>

namespace renderer {

struct FrameTask {
    int number = 1;
    std::filesystem::path camera; ///< .cam file; empty = the scene's own view
    std::vector<std::filesystem::path> outputs;
    bool filmed = false;   ///< its image as it is shown is wanted beside the files
    bool finished = false; ///< its files are there and whole
};

/// The frames of a list that lie in `range`, numbered by their position in the list from 1; may be none.
/// Throws app::UsageError when two outputs of a frame have the same name.
std::vector<FrameTask> pickFrames(std::span<const std::filesystem::path> cameras, const FrameRange& range,
                                  std::span<const std::filesystem::path> patterns);

/// The same for a list that is complete: throws app::UsageError when it has frames, but none in the range.
std::vector<FrameTask> framesOfList(std::span<const std::filesystem::path> cameras, const FrameRange& range,
                                    std::span<const std::filesystem::path> patterns);

/// The one frame of a run without a list.
FrameTask singleFrame(const std::filesystem::path& camera, std::span<const std::filesystem::path> patterns);

/// Throws app::UsageError when one of the frame's outputs is one of `inputs`.
void refuseInputs(const app::InputFiles& inputs, const FrameTask& frame);

/// Those of the chunk, in a row. None when there are more chunks than frames.
std::vector<FrameTask> framesOfChunk(std::vector<FrameTask> frames, const Chunk& chunk);

} // namespace renderer
