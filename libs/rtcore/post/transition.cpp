#include "rtcore/post/transition.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/develop.h"
#include "rtcore/upsample/upsample.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

Colour mix(Colour a, Colour b, float part) { return a + (b - a) * part; }

} // namespace

void Transition::begin(const Frame& frame, const RenderSettings& settings, int threads) {
    const HdrImage& before = frame.radiance;
    settings_ = settings;
    halved_.clear();
    if (radiance_.width != settings.width || radiance_.height != settings.height) {
        radiance_ = HdrImage(settings.width, settings.height);
        image_ = LdrImage(settings.width, settings.height);
    }
    if (before.width == settings.width && before.height == settings.height) {
        const std::size_t width = static_cast<std::size_t>(before.width);
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
        for (int y = 0; y < before.height; ++y) std::copy_n(&before.at(0, y), width, &radiance_.at(0, y));
    } else {
        upsample(before, threads, radiance_);
    }
    sparseCovered_.clear();
    forEachSparse([&](int x, int y) {
        const int column = x * before.width / radiance_.width, row = y * before.height / radiance_.height;
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(before.width) +
                        static_cast<std::size_t>(column);
        sparseCovered_.push_back(frame.covered[at]);
    });
    averageBefore_ = sparseAverage();
}

template <typename Use>
void Transition::forEachSparse(Use&& use) const {
    constexpr int kEvery = 4;
    for (int y = kEvery / 2; y < radiance_.height; y += kEvery) {
        for (int x = kEvery / 2; x < radiance_.width; x += kEvery) use(x, y);
    }
}

std::optional<float> Transition::sparseAverage() {
    sparse_.clear();
    forEachSparse([&](int x, int y) { sparse_.push_back(radiance_.at(x, y)); });
    sparseHistogram_.clear();
    sparseHistogram_.count(sparse_, sparseCovered_);
    return sparseHistogram_.logAverage();
}

float Transition::brightening() {
    const std::optional<float> now = averageBefore_ ? sparseAverage() : std::nullopt;
    return now ? *now / *averageBefore_ : 1;
}

void Transition::step(const std::vector<PixelArea>& finished, const HdrImage& after) {
    const auto show = [&](const std::vector<PixelArea>& areas, auto&& shown) {
        for (const PixelArea& area : areas) {
            for (int y = area.top; y < area.top + area.rows; ++y) {
                for (int x = area.left; x < area.left + area.columns; ++x)
                    radiance_.at(x, y) = shown(radiance_.at(x, y), after.at(x, y));
            }
            develop(area);
        }
    };
    show(halved_, [](Colour, Colour light) { return light; });
    show(finished, [](Colour before, Colour light) { return mix(before, light, 0.5F); });
    halved_ = finished;
}

void Transition::expose(float exposure) {
    exposure_ = exposure;
    effects_.beginRows(EffectStage::Radiance, radiance_, 1,
                       {.settings = settings_, .threads = 1, .exposure = exposure_});
    develop({0, 0, radiance_.width, radiance_.height});
}

void Transition::develop(const PixelArea& area) {
    Development how = developmentOf(settings_, exposure_);
    if (falseColours_) how.falseColours = &*falseColours_;
    developPart(radiance_, how, effects_, area, image_);
}

} // namespace rtcore
