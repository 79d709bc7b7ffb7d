#include "rtcore/shading/light/light_choice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/shading/light/light_choice.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"
#include "rtcore/simd/wide-inl.h"

#ifndef RTCORE_SHADING_LIGHT_LIGHT_CHOICE_TYPES
#define RTCORE_SHADING_LIGHT_LIGHT_CHOICE_TYPES
namespace rtcore {

/// By point: what one light adds, the reciprocal of a step, and the part of a step that has passed.
struct ChoiceArrays {
    const float *added, *perStep;
    float* passed;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

void weighLight(const ArraysOf3& contribution, std::size_t count, float* added, float* sum) {
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Float value = luminance<Float>(loadAt(contribution, i));
        store(value, added + i);
        store(load(sum + i) + value, sum + i);
    }
}

void findSteps(float steps, std::size_t count, float* sum) {
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Float all = load(sum + i);
        store(selectOrZero(all > 0.0F, steps / all), sum + i);
    }
}

std::size_t takeLight(const ChoiceArrays& of, std::size_t count, std::uint32_t* points, float* weights) {
    std::size_t taken = 0;
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Float part = load(of.added + i) * load(of.perStep + i);
        const Mask surely = part >= 1.0F;
        const Float passed = load(of.passed + i) + selectOrZero(part < 1.0F, part);
        const Mask byChance = passed >= 1.0F;
        store(passed - selectOrZero(byChance, Float(1.0F)), of.passed + i);
        const Mask takes = surely | byChance;
        if (none(takes)) continue;
        const Compressor some(takes);
        some.store(iota(i), points + taken);
        some.store(select(surely, Float(1.0F), 1.0F / part), weights + taken);
        taken += some.count();
    }
    return taken;
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(weighLight);
HWY_EXPORT(findSteps);
HWY_EXPORT(takeLight);

void LightChoice::resize(std::size_t points, std::size_t lights) {
    count_ = points;
    stride_ = (points + kWaveBlock - 1) / kWaveBlock * kWaveBlock;
    weighed_ = taken_ = 0;
    if (added_.size() < stride_ * lights) added_.resize(stride_ * lights);
    sum_.assign(stride_, 0);
    passed_.assign(stride_, 0);
    if (points_.size() < stride_ + kWaveBlock) {
        points_.resize(stride_ + kWaveBlock);
        weights_.resize(stride_ + kWaveBlock);
    }
}

void LightChoice::weigh(const ArraysOf3& contribution) {
    HWY_DYNAMIC_DISPATCH(weighLight)(contribution, count_, row(weighed_++), sum_.data());
}

void LightChoice::end() { HWY_DYNAMIC_DISPATCH(findSteps)(kSteps, count_, sum_.data()); }

LightChoice::Taken LightChoice::next() {
    const ChoiceArrays of{row(taken_++), sum_.data(), passed_.data()};
    const std::size_t taken = HWY_DYNAMIC_DISPATCH(takeLight)(of, count_, points_.data(), weights_.data());
    return {{points_.data(), taken}, {weights_.data(), taken}};
}

} // namespace rtcore
#endif
