#include "rtcore/shading/sample_sums.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/sample_sums.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/shading/surface/material_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

void startAll(Colour background, const SurfaceWave& s, const ArraysOf3& radiance,
              std::uint8_t* HWY_RESTRICT hit) {
    const hn::Rebind<std::uint8_t, FloatTag> d8;
    const Float3 missed = broadcast(background);
    for (std::size_t i = 0; i < s.size(); i += lanes()) {
        const Uint point = load(s.traits + i) & traits::kPoint;
        hn::StoreU(hn::U8FromU32(point.raw), d8, hit + i);
        storeAt(selectOrZero(!hasTrait(point, traits::kPoint), missed), radiance, i);
        storeAt(broadcast(kWhite), s.weight, i);
    }
}

void addAll(const SurfaceWave& s, const ArraysOf3& radiance) {
    for (std::size_t i = 0; i < s.size(); i += lanes())
        storeAt(loadAt(radiance, i) + loadAt(s.contribution, i), radiance, i);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(startAll);
HWY_EXPORT(addAll);

namespace {

void clear(const ArraysOf3& sums, std::size_t count) {
    for (float* const axis : {sums.x, sums.y, sums.z}) std::fill_n(axis, count, 0.0F);
}

} // namespace

void SampleSums::resize(std::size_t count) {
    memory_.resize(keepsTransmitted_ ? 6 : 3, count);
    radiance_ = memory_.arraysOf3(0);
    if (keepsTransmitted_) transmitted_ = memory_.arraysOf3(3);
    hit_.resize(count + kWaveBlock);
}

void SampleSums::startEmpty(std::size_t count) {
    resize(count);
    clear(radiance_, count);
    if (keepsTransmitted_) clear(transmitted_, count);
    std::fill(hit_.begin(), hit_.end(), std::uint8_t{0});
}

void SampleSums::startPart(Colour background, Wave& wave) {
    if (wave.size() == 0) return;
    const std::size_t first = wave.paths.sample(0);
    if (keepsTransmitted_) clear(transmitted_.from(first), wave.size());
    HWY_DYNAMIC_DISPATCH(startAll)
    (keepsTransmitted_ ? Colour{} : background, wave.surfaces, radiance_.from(first), hit_.data() + first);
}

void SampleSums::add(const Wave& wave) {
    const SurfaceWave& surfaces = wave.surfaces;
    if (wave.paths.primary()) {
        if (wave.size() > 0) HWY_DYNAMIC_DISPATCH(addAll)(surfaces, radiance_.from(wave.paths.sample(0)));
        return;
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        add(wave.paths.sample(i), surfaces.contribution.colourAt(i));
}

} // namespace rtcore
#endif
