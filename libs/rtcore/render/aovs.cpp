#include "rtcore/render/aovs.h"

#include "rtcore/platform/threads.h"

#include <algorithm>

namespace rtcore {

void Aovs::begin(const Camera& camera, int width, int height) {
    width_ = width;
    height_ = height;
    eye_ = camera.eye;
    axis_ = normalize(camera.forward);
    panorama_ = camera.kind == CameraKind::Panorama;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    pixels_.assign(count, {});
    sums_.assign(count, {});
}

void Aovs::add(std::span<const PrimaryHit> hits, std::span<const SampleId> samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t at =
            static_cast<std::size_t>(samples[i].y) * static_cast<std::size_t>(width_) + samples[i].x;
        ++sums_[at].samples;
        const PrimaryHit& hit = hits[i];
        if (!hit.any()) continue;
        AovPixel& pixel = pixels_[at];
        const Vec3 way = hit.position - eye_;
        pixel.depth = std::min(pixel.depth, panorama_ ? length(way) : dot(way, axis_));
        pixel.normal += hit.normal;
        pixel.albedo += hit.albedo;
        pixel.direct += hit.direct;
        pixel.soft += hit.soft;
        pixel.covered += 1;
        if (hit.shines) pixel.shining += 1;
        if (hit.matte > hit.mirrored) {
            pixel.matte += hit.matte;
            ++sums_[at].matte;
        }
        sums_[at].arriving += hit.arriving;
        sums_[at].whole += hit.whole;
    }
}

void Aovs::finish([[maybe_unused]] int threads) {
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(width_); ++i) {
            const Sums& sums = sums_[i];
            if (sums.samples == 0) continue;
            AovPixel& pixel = pixels_[i];
            const float fraction = 1 / static_cast<float>(sums.samples);
            pixel.normal *= fraction;
            pixel.albedo = pixel.albedo * fraction;
            pixel.direct = pixel.direct * fraction;
            pixel.soft = pixel.soft * fraction;
            pixel.covered *= fraction;
            pixel.shining *= fraction;
            pixel.matte = sums.matte == sums.samples ? pixel.matte * fraction : 0;
            if (sums.whole > 0) pixel.visible = std::min(sums.arriving / sums.whole, 1.0F);
        }
    }
}

} // namespace rtcore
