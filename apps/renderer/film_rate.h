/// How fast a film runs.
#pragma once

#include "renderer/frame_list.h"

#include <span>

namespace renderer {

inline constexpr double kUsualFrameRate = 25;

/// Frames per second by the times that the first and the last frame's .cam files name, so that a recording is
/// shown as fast as it was made; kUsualFrameRate when they name none, or none that make sense.
double recordedFrameRate(std::span<const FrameTask> frames);

} // namespace renderer
