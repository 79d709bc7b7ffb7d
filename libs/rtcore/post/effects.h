/// THE list of effects, in their order. Frames, previews, the check of memory and what collects AOVs
/// walk it.
#pragma once

#include "rtcore/post/effect.h"

#include <cstddef>
#include <span>

namespace rtcore {

/// All of EffectStage::Radiance before those of EffectStage::Display. Safe from many threads.
std::span<const EffectRow* const> effects();

/// Bytes for each pixel that the wanted effects take beside the frame's radiance: AOVs, guides, and the
/// halves of the samples with their sums, included.
std::size_t effectBytesPerPixel(const RenderSettings& settings);

/// Whether a wanted effect reads the frame's AOVs: for FrameRenderer::collectAovs().
bool effectsNeedAovs(const RenderSettings& settings);

/// Whether a wanted effect reads the frame's guides: for ImageRequest::guides.
bool effectsNeedGuides(const RenderSettings& settings);

} // namespace rtcore
