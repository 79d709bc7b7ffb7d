#include "bench/walk/path_truth.h"

#include "bench/walk/uncovered.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <utility>

namespace bench {

namespace {

rtcore::RenderSettings withoutDenoising(rtcore::RenderSettings settings) {
    settings.denoise.passes = settings.path.filter = 0;
    settings.denoise.net = rtcore::DenoiseNet::Off;
    return settings;
}

rtcore::HdrImage meanOf(const rtcore::HdrImage& one, const rtcore::HdrImage& other) {
    rtcore::HdrImage mean = one;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        mean.pixels[i] = 0.5F * (one.pixels[i] + other.pixels[i]);
    return mean;
}

} // namespace

PathTruth::PathTruth(const WalkOptions& options, const LiveServer& server,
                     const std::vector<rtcore::Camera>& cameras, const rtcore::RenderSettings& settings)
    : options_(options), server_(server), cameras_(cameras), settings_(withoutDenoising(settings)),
      references_(options, server.document(), settings, cameras) {}

PicturePair PathTruth::pairOf(const Published& picture, std::size_t camera) {
    if (picture.light.empty())
        throw std::runtime_error(
            fmt::format("the light that was seen at camera {} is not known: frames take too long", camera));
    PathReferences::Pair truth = references_.read(camera);
    rtcore::Frame mean;
    mean.radiance = meanOf(truth.one, truth.other);
    findCover(cameras_[camera], mean);
    const float exposure = exposureOf(cameras_[camera], mean); // as ever without the effects
    addEffects(truth.one);
    addEffects(truth.other);
    addEffects(mean.radiance);
    return {.shown = develop(picture.light, server_.document().settings(), picture.exposure),
            .wanted = develop(mean.radiance, settings_, exposure),
            .pixelsPerDegree = test::Flip::kPixelsPerDegree * static_cast<float>(options_.truthWidth) /
                               static_cast<float>(options_.width),
            .light = lightErrors(picture.light, truth.one, truth.other),
            .uncovered = camera > 0
                             ? lightErrorsOf(uncoveredByTurn(cameras_[camera - 1], cameras_[camera],
                                                             picture.light.width, picture.light.height),
                                             picture.light, truth.one, truth.other)
                             : std::optional<LightErrors>()};
}

/// Bloom, which the walk's light has as well; it is linear, so references stay independent and unbiased.
void PathTruth::addEffects(rtcore::HdrImage& radiance) {
    rtcore::Frame frame;
    frame.radiance = std::move(radiance);
    radiance = developer_.finish(frame, settings_, 0);
}

/// Frame::covered, by rays without light.
void PathTruth::findCover(const rtcore::Camera& camera, rtcore::Frame& frame) {
    rtcore::RenderSettings rays = references_.settings();
    rays.integrator = rtcore::Integrator::Whitted;
    rays.shadows = rays.reflections = rays.refractions = false;
    const rtserver::Document& document = server_.document();
    rtcore::RenderControl control;
    rtcore::Frame seen;
    rays_.render({*document.scene(), *document.tracer(), camera, rays}, control, seen);
    frame.covered = std::move(seen.covered);
}

float PathTruth::exposureOf(const rtcore::Camera& camera, const rtcore::Frame& frame) {
    const rtserver::Document& document = server_.document();
    rtcore::RenderControl control;
    std::optional<float> white;
    if (settings_.exposure.mode == rtcore::ExposureMode::Incident)
        white =
            meter_.white({*document.scene(), *document.tracer(), camera, references_.settings()}, control);
    return developer_.exposure(frame, settings_, white, control.threads);
}

rtcore::LdrImage PathTruth::develop(const rtcore::HdrImage& radiance, const rtcore::RenderSettings& settings,
                                    float exposure) {
    rtcore::LdrImage image;
    developer_.develop(radiance, settings, exposure, 0, image);
    return image;
}

} // namespace bench
