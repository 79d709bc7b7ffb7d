#include "rtcore/post/net_denoise.h"

#include "rtcore/platform/threads.h"
#include "rtcore/render/guides.h"

namespace rtcore {

namespace {

PixelPlane planeOf(const HdrImage& picture) { return {&picture.pixels[0].r, sizeof(Colour) / sizeof(float)}; }

PixelPlane planeOf(const std::vector<Vec3>& vectors) { return {&vectors[0].x, sizeof(Vec3) / sizeof(float)}; }

} // namespace

std::optional<Net> netOf(const RenderSettings& settings) {
    if (!denoisesByNet(settings)) return std::nullopt;
    switch (settings.denoise.net) {
    case DenoiseNet::Small:
        return Net::Small;
    case DenoiseNet::Large:
        return Net::Large;
    default:
        return Net::Base;
    }
}

const HdrImage& NetDenoise::apply(const HdrImage& picture, const Aovs&, const EffectRun& run) {
    if (run.net == nullptr || run.guides == nullptr || picture.empty()) return picture;
    const Guides& guides = *run.guides;
    if (guides.albedo.width != picture.width || guides.albedo.height != picture.height) return picture;
    if (!denoiser_ || &denoiser_->net() != run.net.get()) denoiser_.emplace(run.net);
    if (image_.width != picture.width || image_.height != picture.height)
        image_ = HdrImage(picture.width, picture.height);
    const NoisyImage noisy{.width = picture.width,
                           .height = picture.height,
                           .radiance = planeOf(picture),
                           .albedo = planeOf(guides.albedo),
                           .normal = planeOf(guides.normals)};
    if (!denoiser_->run(noisy, &image_.pixels[0].r, run.threads, run.stop)) return picture;
    const auto width = static_cast<std::size_t>(picture.width);
#pragma omp parallel for schedule(static) num_threads(threadsFor(run.threads))
    for (int y = 0; y < picture.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * width;
        for (std::size_t i = row; i < row + width; ++i)
            if (guides.covered[i] == 0) image_.pixels[i] = picture.pixels[i];
    }
    return image_;
}

constinit const EffectRow kNetDenoiseEffect{.name = "denoise by a net",
                                            .stage = EffectStage::Radiance,
                                            .wanted = &denoisesByNet,
                                            .bytesPerPixel = NetDenoise::bytesPerPixel(),
                                            .needsAovs = false,
                                            .needsGuides = true,
                                            .make = &makeEffect<NetDenoise>};

} // namespace rtcore
