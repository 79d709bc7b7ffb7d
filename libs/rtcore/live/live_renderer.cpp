#include "rtcore/live/live_renderer.h"

#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

namespace rtcore {

namespace {

constexpr int kRowsOfPart = 16;

Vec3 towardsMiddle(const ImagePlane& plane, int x, int y) {
    return plane.towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
}

template <typename Work>
void forEachChosen(std::size_t count, int threads, Work&& work) {
    constexpr std::size_t kPart = 256;
    forEachPart((count + kPart - 1) / kPart, threads, [&](std::size_t part) {
        const std::size_t last = std::min((part + 1) * kPart, count);
        for (std::size_t i = part * kPart; i < last; ++i) work(i);
    });
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

bool mirrors(const SeenPoint& seen) { return seen.mirroredLength != 0; }

/// What is lit so through that tint; of channels that it lets nothing through, nothing is known.
Colour over(Colour light, Colour tint) {
    const auto channel = [](float a, float b) { return b > 0 ? a / b : 0; };
    return {channel(light.r, tint.r), channel(light.g, tint.g), channel(light.b, tint.b)};
}

/// A pixel's new samples. `own.position` is where its ray goes, `own.light` all that comes from there.
void setSamples(LiveLayers& layers, std::size_t i, const SeenPoint& seen, LiveSample own) {
    own.background = !seen.any;
    own.mirrors = mirrors(seen);
    LiveSample mirrored = own;
    own.light = own.light * seen.ownPart;
    layers.own.set(i, own);
    if (!layers.mirrors) return;
    if (!own.mirrors) {
        layers.mirrored.forget(i);
        return;
    }
    const ImagePlane& plane = layers.own.plane();
    const Vec3 way = own.position - plane.eye;
    mirrored.light = over(mirrored.light * (kWhite - seen.ownPart), seen.tint);
    layers.tints[i] = packLight(seen.tint);
    mirrored.wanders = seen.mirroredLength < 0;
    mirrored.mirrors = false;
    mirrored.background = std::isinf(seen.mirroredLength);
    mirrored.position =
        mirrored.background ? way : plane.eye + way * (std::fabs(seen.mirroredLength) / length(way));
    layers.mirrored.set(i, mirrored);
}

template <typename Use>
void forEachPixel(const PixelArea& area, Use&& use) {
    for (int y = area.top; y < area.top + area.rows; ++y) {
        for (int x = area.left; x < area.left + area.columns; ++x) use(x, y);
    }
}

/// The samples of an area of a whole frame.
void setSamplesOf(const Frame& frame, const PixelArea& area, std::uint8_t age, LiveLayers& layers) {
    const ImagePlane& plane = layers.own.plane();
    forEachPixel(area, [&](int x, int y) {
        const std::size_t i = layers.own.index(x, y);
        const SeenPoint& seen = frame.seen[i];
        setSamples(layers, i, seen,
                   {.position = seen.any ? positionInMiddle(plane, seen, x, y) : towardsMiddle(plane, x, y),
                    .light = frame.radiance.pixels[i],
                    .lights = {},
                    .age = age});
    });
}

} // namespace

bool LiveRenderer::draws(const View& view) {
    const RenderSettings& settings = view.settings;
    const bool fits = static_cast<double>(settings.width) * settings.height < Reprojection::kMostPixels;
    return fits && view.camera.kind == CameraKind::Perspective && settings.antialiasing == 1 &&
           settings.sampling == SamplingPattern::Grid && !settings.depthOfField.on;
}

ImagePlane LiveRenderer::planeOf(const View& view) {
    const int width = view.settings.width, height = view.settings.height;
    return {CameraRays(view.camera, width, height), width, height};
}

bool LiveRenderer::render(const View& view, double newSamples, RenderControl& control, Frame& frame) {
    const int threads = threadsFor(control.threads);
    present_.mirrors = past_.mirrors;
    present_.resize(planeOf(view));
    frame.radiance.width = view.settings.width;
    frame.radiance.height = view.settings.height;
    frame.radiance.pixels.resize(present_.own.size());
    frame.covered.resize(present_.own.size());
    frame.statistics = {};
    frame.aovs.clear();
    frame.seen.clear();
    choice_.begin(present_.own.plane());
    reprojection_.carry(past_, present_, threads,
                        [&](int first, int last) { choice_.look(present_, first, last); });
    choice_.choose(present_, reprojection_.staleness(), newSamples, number_, threads);
    const auto begun = std::chrono::steady_clock::now();
    if (!lightSamples(view, control, frame)) return false;
    sampleSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    picture_.show(present_, threads, frame);
    meter(threads, frame);
    std::swap(past_, present_);
    ++number_;
    return true;
}

void LiveRenderer::keep(const ImagePlane& plane, const Frame& frame, int threads, std::uint8_t age) {
    forgetChecks();
    past_.own.resize(plane);
    const auto forEachPart = [&](auto&& work) {
        forEachRows(plane.height, kRowsOfPart, threadsFor(threads), work);
    };
    std::atomic<bool> anyMirrors = false;
    forEachPart([&](int first, int last) {
        const std::span part =
            std::span(frame.seen).subspan(past_.own.index(0, first), past_.own.index(0, last - first));
        if (!anyMirrors && std::ranges::any_of(part, mirrors)) anyMirrors = true;
    });
    past_.mirrors = anyMirrors;
    if (past_.mirrors) past_.resizeMirrored(plane);
    forEachPart([&](int first, int last) {
        setSamplesOf(frame, {0, first, plane.width, last - first}, age, past_);
    });
}

void LiveRenderer::keepParts(const View& view, const Frame& frame, std::span<const PixelArea> parts,
                             int threads) {
    present_.mirrors = past_.mirrors;
    present_.resize(planeOf(view));
    reprojection_.carry(past_, present_, threadsFor(threads), [](int, int) {});
    const auto mirrorsIn = [&](const PixelArea& part) {
        bool any = false;
        forEachPixel(part, [&](int x, int y) { any |= mirrors(frame.seen[present_.own.index(x, y)]); });
        return any;
    };
    if (!present_.mirrors && std::ranges::any_of(parts, mirrorsIn)) beginMirroring();
    forEachPart(parts.size(), threadsFor(threads),
                [&](std::size_t i) { setSamplesOf(frame, parts[i], 0, present_); });
    std::swap(past_, present_);
}

double LiveRenderer::relight(const LightChange& change, int threads) {
    LiveSamples& own = past_.own;
    const auto unknownOf = [&](std::size_t i) {
        if (past_.mirrors) past_.mirrored.forget(i);
        if (!own.known(i)) return true;
        const bool mirrors = own.mirrors(i),
                   reached =
                       !own.background(i) && change.reaches(own.points[i].position, luminance(own.light(i)));
        if (reached) own.forget(i);
        return reached || mirrors;
    };
    std::atomic<std::size_t> unknown = 0;
    forEachRows(own.plane().height, kRowsOfPart, threadsFor(threads), [&](int first, int last) {
        std::size_t here = 0;
        for (std::size_t i = own.index(0, first); i < own.index(0, last); ++i) here += unknownOf(i) ? 1U : 0U;
        unknown += here;
    });
    return own.size() > 0 ? static_cast<double>(unknown) / static_cast<double>(own.size()) : 1;
}

/// From here on what is mirrored is kept, of which nothing is known yet.
void LiveRenderer::beginMirroring() {
    const ImagePlane& plane = present_.own.plane();
    present_.mirrors = true;
    present_.resizeMirrored(plane);
    present_.mirrored.clear(plane);
}

bool LiveRenderer::follows(Vec3 eye, const RayTracer& tracer) {
    return empty() || (!isFar(eye) && !crossesSurface(eye, tracer));
}

bool LiveRenderer::isFar(Vec3 eye) const {
    constexpr float kMost = 0.25F; // of how far away things are
    constexpr std::size_t kEvery = 97;
    const LiveSamples& own = past_.own;
    const Vec3 before = own.plane().eye;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < own.size(); i += kEvery) {
        if (!own.known(i) || own.background(i)) continue;
        sum += std::log(static_cast<double>(length(own.points[i].position - before)) + 1e-30);
        ++count;
    }
    if (count == 0) return false; // all that was seen is endlessly far away
    return !(length(eye - before) < kMost * static_cast<float>(std::exp(sum / count)));
}

bool LiveRenderer::crossesSurface(Vec3 eye, const RayTracer& tracer) {
    const Vec3 before = past_.own.plane().eye;
    if (eye == before) return false;
    way_.clear();
    way_.push({before, 0, eye - before, 1});
    tracer.occluded(RayKind::Shadow, way_, crossed_);
    return crossed_[0] != 0;
}

/// What is known of lights at a point, but for those that some of the samples around see and others do not:
/// the edges of shadows stay where they are. In turns nothing counts as known, so that no error lasts.
LightVisibility LiveRenderer::surelyKnown(int x, int y) const {
    constexpr std::uint32_t kDoubted = 64; // in every such frame
    const LiveSamples& own = present_.own;
    const std::size_t at = own.index(x, y);
    if (!own.known(at) || (turnOf(x, y) + number_) % kDoubted == 0) return {};
    const ImagePlane& plane = own.plane();
    unsigned clear = 0, dark = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, plane.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, plane.width - 1); ++u) {
            if (!own.known(own.index(u, v))) return {};
            const LightVisibility there = own.lights[own.index(u, v)].lights;
            clear |= there.clear;
            dark |= there.dark;
        }
    }
    const unsigned sure = ~(clear & dark);
    const LightVisibility here = own.lights[at].lights;
    return {here.clear & sure, here.dark & sure};
}

bool LiveRenderer::lightSamples(const View& view, RenderControl& control, Frame& frame) {
    const std::vector<SampleId>& chosen = choice_.chosen();
    light_.resize(chosen.size());
    visibility_.resize(chosen.size());
    seen_.resize(chosen.size());
    const int threads = threadsFor(control.threads);
    forEachChosen(chosen.size(), threads,
                  [&](std::size_t i) { visibility_[i] = surelyKnown(chosen[i].x, chosen[i].y); });
    newSamples_ = static_cast<double>(chosen.size()) / static_cast<double>(present_.own.size());
    if (!renderer_.renderPixels(view, chosen, control, {light_, visibility_, seen_}, frame.statistics))
        return false;
    const ImagePlane& plane = present_.own.plane();
    if (!present_.mirrors && std::any_of(seen_.begin(), seen_.end(), mirrors)) beginMirroring();
    check();
    forEachChosen(chosen.size(), threads, [&](std::size_t i) {
        const int x = chosen[i].x, y = chosen[i].y;
        setSamples(present_, present_.own.index(x, y), seen_[i],
                   {.position = seen_[i].any ? seen_[i].position : towardsMiddle(plane, x, y),
                    .light = light_[i],
                    .lights = visibility_[i]});
        choice_.traced(plane, x, y, luminance(light_[i]));
    });
    return true;
}

void LiveRenderer::forgetChecks() {
    for (std::vector<CheckedPixel>& checked : checked_) checked.clear();
}

/// Stale light may be brighter or darker than the truth, and the exposure must not follow it. Before the new
/// samples take the place of the old ones.
void LiveRenderer::check() {
    const ImagePlane& plane = present_.own.plane();
    std::vector<CheckedPixel>& checked = checked_[number_ % kCheckedFrames];
    checked.clear();
    for (const PixelChoice::Check& check : choice_.checked()) {
        const SampleId pixel = choice_.chosen()[check.chosen];
        const float traced = luminance(light_[check.chosen]),
                    kept = choice_.luminances(plane, pixel.y)[pixel.x];
        const auto covered = [](bool is) -> std::uint8_t { return is ? 255 : 0; };
        const std::uint8_t tracedCovered = covered(seen_[check.chosen].any);
        if (check.blind && kept >= 0) {
            const bool background = present_.own.background(present_.own.index(pixel.x, pixel.y));
            checked.push_back({kept, traced, covered(!background), tracedCovered});
        } else {
            checked.push_back({traced, traced, tracedCovered, tracedCovered});
        }
    }
}

/// The exposure is that of samples, not of the image that is weighed from them: that has fewer black pixels,
/// so its log-average differs. Pixels without a sample count as those before them.
void LiveRenderer::meter(int threads, Frame& frame) const {
    const LiveSamples& own = present_.own;
    frame.metered.resize(own.size());
    forEachRows(own.plane().height, kRowsOfPart, threads, [&](int first, int last) {
        const std::size_t from = own.index(0, first), to = own.index(0, last);
        std::size_t known = from;
        while (known < to && !present_.known(known)) ++known;
        float there = -1;
        std::uint8_t covered = known < to && own.background(known) ? 0 : 255;
        for (int y = first; y < last; ++y) {
            const std::span<const float> luminances = choice_.luminances(own.plane(), y);
            const std::size_t row = own.index(0, y);
            for (std::size_t x = 0; x < luminances.size(); ++x) {
                if (luminances[x] >= 0) {
                    there = luminances[x];
                    covered = own.background(row + x) ? 0 : 255;
                }
                frame.metered[row + x] = there;
                frame.covered[row + x] = covered;
            }
        }
    });
    frame.checked.clear();
    for (const std::vector<CheckedPixel>& checked : checked_)
        frame.checked.insert(frame.checked.end(), checked.begin(), checked.end());
}

} // namespace rtcore
