/// How far a measurement of light is, and the word to give it up.
#pragma once

#include "rtcore/render/frame_renderer.h"

#include <atomic>

namespace rtserver {

/// One thread measures; any other may read `fraction`, and set `control.cancel`.
struct Measuring {
    rtcore::RenderControl control;
    std::atomic<double> fraction{0}; ///< 0..1
};

} // namespace rtserver
