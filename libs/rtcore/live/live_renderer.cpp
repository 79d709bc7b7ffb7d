#include "rtcore/live/live_renderer.h"

#include "rtcore/live/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace rtcore {

namespace {

constexpr int kRowsOfPart = 16;

ImagePlane planeOf(const View& view) {
    const int width = view.settings.width, height = view.settings.height;
    return {CameraRays(view.camera, width, height), width, height};
}

Vec3 towardsMiddle(const ImagePlane& plane, int x, int y) {
    return plane.towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
}

/// Where the surface of `seen` is in the middle of the pixel.
Vec3 positionInMiddle(const ImagePlane& plane, const SeenPoint& seen, int x, int y) {
    constexpr float kMostChange = 0.05F;
    const Vec3 towards = towardsMiddle(plane, x, y), offset = seen.position - plane.eye;
    const float depth = dot(seen.normal, offset) / dot(seen.normal, towards),
                before = dot(plane.axis, offset);
    const bool near = std::fabs(depth - before) < kMostChange * before; // not of NaN
    return near ? plane.eye + towards * depth : seen.position;
}

} // namespace

bool sameLight(const RenderSettings& a, const RenderSettings& b) {
    RenderSettings alike = a;
    alike.width = b.width;
    alike.height = b.height;
    alike.antialiasing = b.antialiasing;
    alike.sampling = b.sampling;
    alike.adaptive = b.adaptive;
    alike.depthOfField = b.depthOfField;
    alike.denoise = b.denoise;
    alike.bloom = b.bloom;
    alike.exposure = b.exposure;
    alike.toneMapping = b.toneMapping;
    alike.dithering = b.dithering;
    return alike == b;
}

bool LiveRenderer::draws(const View& view) {
    const RenderSettings& settings = view.settings;
    const bool fits = static_cast<double>(settings.width) * settings.height < Reprojection::kMostPixels;
    return fits && view.camera.kind == CameraKind::Perspective && settings.antialiasing == 1 &&
           settings.sampling == SamplingPattern::Grid && !settings.depthOfField.on;
}

bool LiveRenderer::render(const View& view, double newSamples, RenderControl& control, Frame& frame) {
    const int threads = threadsFor(control.threads);
    present_.resize(planeOf(view));
    frame.radiance.width = view.settings.width;
    frame.radiance.height = view.settings.height;
    frame.radiance.pixels.resize(present_.size());
    frame.covered.resize(present_.size());
    frame.statistics = {};
    frame.aovs.clear();
    frame.seen.clear();
    reprojection_.carry(past_, present_, threads);
    choice_.choose(present_, reprojection_.staleness(), newSamples, number_, threads);
    const auto begun = std::chrono::steady_clock::now();
    if (!lightSamples(view, control, frame)) return false;
    sampleSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    picture_.show(present_, threads, frame);
    std::swap(past_, present_);
    ++number_;
    return true;
}

void LiveRenderer::keep(const View& view, const Frame& frame, int threads, std::uint8_t age) {
    past_.resize(planeOf(view));
    const ImagePlane& plane = past_.plane();
    forEachRows(plane.height, kRowsOfPart, threadsFor(threads), [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            for (int x = 0; x < plane.width; ++x) {
                const std::size_t i = past_.index(x, y);
                const SeenPoint& seen = frame.seen[i];
                past_.set(i, {.position =
                                  seen.any ? positionInMiddle(plane, seen, x, y) : towardsMiddle(plane, x, y),
                              .light = frame.radiance.pixels[i],
                              .lights = {},
                              .mirrored = seen.mirrored,
                              .background = !seen.any,
                              .age = age});
            }
        }
    });
}

/// What is known of lights at a point, but for those that some of the samples around see and others do not:
/// the edges of shadows stay where they are. In turns nothing counts as known, so that no error lasts.
LightVisibility LiveRenderer::surelyKnown(int x, int y) const {
    const std::size_t at = present_.index(x, y);
    if (!present_.known(at) || (turnOf(x, y) + number_) % kTurns == 0) return {};
    const ImagePlane& plane = present_.plane();
    unsigned clear = 0, dark = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, plane.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, plane.width - 1); ++u) {
            if (!present_.known(present_.index(u, v))) return {};
            const LightVisibility there = present_.visibility(present_.index(u, v));
            clear |= there.clear;
            dark |= there.dark;
        }
    }
    const unsigned sure = ~(clear & dark);
    const LightVisibility own = present_.visibility(at);
    return {static_cast<std::uint16_t>(own.clear & sure), static_cast<std::uint16_t>(own.dark & sure)};
}

bool LiveRenderer::lightSamples(const View& view, RenderControl& control, Frame& frame) {
    const std::vector<SampleId>& chosen = choice_.chosen();
    light_.resize(chosen.size());
    visibility_.resize(chosen.size());
    seen_.resize(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) visibility_[i] = surelyKnown(chosen[i].x, chosen[i].y);
    newSamples_ = static_cast<double>(chosen.size()) / static_cast<double>(present_.size());
    if (!renderer_.renderPixels(view, chosen, control, {light_, visibility_, seen_}, frame.statistics))
        return false;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const int x = chosen[i].x, y = chosen[i].y;
        const SeenPoint& seen = seen_[i];
        present_.set(present_.index(x, y),
                     {.position = seen.any ? seen.position : towardsMiddle(present_.plane(), x, y),
                      .light = light_[i],
                      .lights = visibility_[i],
                      .mirrored = seen.mirrored,
                      .background = !seen.any});
    }
    return true;
}

} // namespace rtcore
