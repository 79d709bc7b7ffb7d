#include "rtcore/post/effects.h"

#include "rtcore/post/background.h"
#include "rtcore/post/bloom.h"
#include "rtcore/post/denoise.h"
#include "rtcore/post/local_exposure.h"
#include "rtcore/post/net_denoise.h"
#include "rtcore/post/net_mix.h"
#include "rtcore/render/aovs.h"
#include "rtcore/render/guides.h"
#include "rtcore/render/image_sums.h"
#include "rtcore/render/sample_halves.h"
#include "rtcore/render/steady_image.h"

#include <algorithm>
#include <array>

namespace rtcore {

namespace {

constexpr std::array<const EffectRow*, 5> kEffects{&kNetDenoiseEffect, &kDenoiseEffect, &kBackgroundEffect,
                                                   &kBloomEffect, &kLocalExposureEffect};

/// Whether one that is wanted needs that.
bool anyNeeds(bool EffectRow::*need, const RenderSettings& settings) {
    return std::ranges::any_of(kEffects,
                               [&](const EffectRow* row) { return row->*need && row->wanted(settings); });
}

} // namespace

std::span<const EffectRow* const> effects() { return kEffects; }

std::size_t effectBytesPerPixel(const RenderSettings& settings) {
    std::size_t bytes = effectsNeedAovs(settings) ? Aovs::bytesPerPixel() : 0;
    if (effectsNeedGuides(settings)) bytes += Guides::bytesPerPixel();
    for (const EffectRow* row : kEffects) bytes += row->wanted(settings) ? row->bytesPerPixel : 0;
    if (keepsHalves(settings))
        bytes +=
            SampleHalves::kBytesPerPixel + ImageSums::kHalfBytesPerPixel + EstimatedError::kBytesPerPixel;
    if (mixesSteadyImage(settings)) bytes += SteadyImage::kBytesPerPixel;
    return bytes;
}

bool effectsNeedAovs(const RenderSettings& settings) { return anyNeeds(&EffectRow::needsAovs, settings); }

bool effectsNeedGuides(const RenderSettings& settings) { return anyNeeds(&EffectRow::needsGuides, settings); }

} // namespace rtcore
