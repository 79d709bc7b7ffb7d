/// Rays of samples, from their ids.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/lens.h"
#include "rtcore/render/view.h"
#include "rtcore/sampling/aperture.h"
#include "rtcore/sampling/lens_pattern.h"
#include "rtcore/sampling/pixel_pattern.h"

#include <cstdint>
#include <optional>
#include <span>

namespace rtcore {

/// Everything that determines the rays of a frame's samples.
struct SampleView {
    CameraRays camera;
    Lens lens;
    PixelPattern pattern;
    LensPattern lensPattern;
    Aperture aperture;
    /// Places in pixels and on the lens follow the sequences of paths with this seed, any number of samples
    /// long; else the patterns.
    std::optional<std::uint32_t> pathSeed;

    /// Samples in the middles of a grid's cells, all seen from one point.
    bool plain() const {
        return pattern.pattern() == SamplingPattern::Grid && !lens.open() && !camera.parallel();
    }
};

/// Sets the camera, its lens and aperture. `focus` keeps memory from frame to frame.
void aimSamples(const View& view, FocusFinder& focus, SampleView& samples);

/// One ray from 0 to infinity with a direction of unit length for each sample, in their order; they start on
/// the lens, or in the plane of an orthographic camera, and pass through the point of perfect sharpness.
/// Without a lens they have the bits of CameraRays::at().
void makeSampleRays(const SampleView& view, std::span<const SampleId> samples, RayWave& rays);

} // namespace rtcore
