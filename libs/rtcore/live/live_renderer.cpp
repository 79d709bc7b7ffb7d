#include "rtcore/live/live_renderer.h"

#include "rtcore/math/constants.h"
#include "rtcore/math/packed_direction.h"
#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"
#include "rtcore/shading/fog/fog.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

namespace rtcore {

namespace {

constexpr int kRowsOfPart = 16;

/// LiveSample::position of the background in the middle of that pixel. `depth`: of the surfaces around: as
/// the view turns, it moves as they do.
Vec3 backgroundAt(const ImagePlane& plane, int x, int y, float depth) {
    const float middleX = static_cast<float>(x) + 0.5F, middleY = static_cast<float>(y) + 0.5F;
    return plane.parallel ? plane.inDepth(middleX, middleY, depth) : plane.towards(middleX, middleY);
}

/// The mean depth of `count` points, some of them: positionAt(i) is null where there is none. 0 where the
/// background needs no depth.
template <typename PositionAt>
float meanDepth(const ImagePlane& plane, std::size_t count, PositionAt&& positionAt) {
    constexpr std::size_t kEvery = 97;
    if (!plane.parallel) return 0;
    double sum = 0;
    int points = 0;
    for (std::size_t i = 0; i < count; i += kEvery) {
        const Vec3* const position = positionAt(i);
        if (position == nullptr) continue;
        sum += static_cast<double>(plane.depthOf(*position));
        ++points;
    }
    return points > 0 ? static_cast<float>(sum / points) : 0;
}
float meanDepth(const LiveSamples& samples) {
    return meanDepth(samples.plane(), samples.size(), [&](std::size_t i) {
        return samples.known(i) && !samples.background(i) ? &samples.points[i].position : nullptr;
    });
}
float meanDepth(const ImagePlane& plane, const std::vector<SeenPoint>& seen) {
    return meanDepth(plane, seen.size(),
                     [&](std::size_t i) { return seen[i].any ? &seen[i].position : nullptr; });
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
    constexpr float kMaxChange = 0.05F;
    const float middleX = static_cast<float>(x) + 0.5F, middleY = static_cast<float>(y) + 0.5F;
    const Vec3 start = plane.inDepth(middleX, middleY, 0), offset = seen.position - start;
    const Vec3 towards = plane.parallel ? plane.axis : plane.towards(middleX, middleY);
    const float depth = dot(seen.normal, offset) / dot(seen.normal, towards),
                before = dot(plane.axis, offset);
    const bool near = std::fabs(depth - before) < kMaxChange * (before + plane.addedDepth); // not of NaN
    return near ? start + towards * depth : seen.position;
}

bool mirrors(const SeenPoint& seen) { return seen.specularDistance != 0; }

/// `light` before that tint; 0 in channels that the tint absorbs, where nothing is known.
Colour over(Colour light, Colour tint) {
    const auto channel = [](float a, float b) { return b > 0 ? a / b : 0; };
    return {channel(light.r, tint.r), channel(light.g, tint.g), channel(light.b, tint.b)};
}

/// Sets a pixel's new samples. `surface.position`: where its ray ends, `surface.light`: the radiance along
/// the ray.
void setSamples(LiveLayers& layers, std::size_t i, const SeenPoint& seen, LiveSample surface) {
    surface.background = !seen.any;
    surface.mirrors = mirrors(seen);
    LiveSample specular = surface;
    surface.light = surface.light * seen.surfaceFraction;
    layers.surface.set(i, surface);
    if (layers.updatesLight) layers.surface.matter[i] = {};
    if (!layers.mirrors) return;
    if (!surface.mirrors) {
        layers.specular.forget(i);
        return;
    }
    const ImagePlane& plane = layers.surface.plane();
    specular.light = over(specular.light * (kWhite - seen.surfaceFraction), seen.tint);
    layers.tints[i] = packLight(seen.tint);
    specular.unreliable = seen.specularDistance < 0;
    specular.mirrors = false;
    specular.background = std::isinf(seen.specularDistance);
    if (!specular.background) {
        specular.position = plane.alongRay(surface.position, std::fabs(seen.specularDistance));
    } else if (!plane.parallel) {
        specular.position = surface.position - plane.eye;
    }
    layers.specular.set(i, specular);
}

/// Whether surfaces of a parallel view have about as many samples in each pixel of another: it has nearly
/// that direction and size.
bool isAlike(const ImagePlane& before, const ImagePlane& now) {
    constexpr float kMax = 0.25F; // of a perspective view's distance (LiveRenderer::isFar)
    const float times = now.addedDepth / before.addedDepth;
    return length(now.axis - before.axis) < kMax && times > 1 - kMax && times < 1 / (1 - kMax);
}

/// Whether a parallel view shows half of the surfaces of another, by some samples.
bool showsHalf(const LiveSamples& samples, const ImagePlane& now) {
    constexpr std::size_t kEvery = 97;
    std::size_t known = 0, seen = 0;
    for (std::size_t i = 0; i < samples.size(); i += kEvery) {
        if (!samples.known(i) || samples.background(i)) continue;
        ++known;
        const Vec3 offset = samples.points[i].position - now.eye;
        const float x = dot(now.column, offset - now.corner), y = dot(now.row, offset - now.corner);
        const bool ahead = dot(now.axis, offset) > 0;
        const auto width = static_cast<float>(now.width), height = static_cast<float>(now.height);
        seen += ahead && x >= 0 && x < width && y >= 0 && y < height ? 1U : 0U;
    }
    return 2 * seen >= known;
}

template <typename Use>
void forEachPixel(const PixelArea& area, Use&& use) {
    for (int y = area.top; y < area.top + area.rows; ++y) {
        for (int x = area.left; x < area.left + area.columns; ++x) use(x, y);
    }
}

/// The age of samples of a whole frame, and meanDepth() there.
struct Seeds {
    std::uint8_t age = 0;
    float depth = 0;
};

/// The samples of an area of a whole frame.
void setSamplesOf(const Frame& frame, const PixelArea& area, const Seeds& seeds, LiveLayers& layers) {
    const ImagePlane& plane = layers.surface.plane();
    // Indirect light is learned about true points: others may lie behind a wall.
    const bool updates = layers.updatesLight && !frame.matter.empty();
    forEachPixel(area, [&](int x, int y) {
        const std::size_t i = layers.surface.index(x, y);
        const SeenPoint& seen = frame.seen[i];
        setSamples(layers, i, seen,
                   {.position = !seen.any ? backgroundAt(plane, x, y, seeds.depth)
                                : updates ? seen.position
                                          : positionInMiddle(plane, seen, x, y),
                    .light = frame.radiance.pixels[i],
                    .lights = {},
                    .age = seeds.age});
        if (updates) layers.surface.matter[i] = frame.matter[i];
    });
}

} // namespace

bool LiveRenderer::supports(const View& view) {
    const RenderSettings& settings = view.settings;
    const bool fits = static_cast<double>(settings.width) * settings.height < Reprojection::kMaxPixels;
    return fits && settings.antialiasing == 1 && settings.sampling == SamplingPattern::Grid &&
           !settings.depthOfField.on;
}

ImagePlane LiveRenderer::planeOf(const View& view) {
    const int width = view.settings.width, height = view.settings.height;
    return {CameraRays(view.camera, width, height), width, height};
}

bool LiveRenderer::render(const View& view, double newSamples, RenderControl& control, Frame& frame) {
    const int threads = threadsFor(control.threads);
    forgetOtherProjection(planeOf(view));
    present_.mirrors = past_.mirrors;
    present_.updatesLight = indirect_ != nullptr;
    if (present_.updatesLight && !past_.updatesLight) past_.beginUpdating();
    present_.resize(planeOf(view));
    frame.radiance.width = view.settings.width;
    frame.radiance.height = view.settings.height;
    frame.radiance.pixels.resize(present_.surface.size());
    frame.covered.resize(present_.surface.size());
    frame.statistics = {};
    frame.aovs.clear();
    frame.seen.clear();
    frame.matter.clear();
    selector_.begin(present_.surface.plane());
    reproject(view.tracer, threads, [&](int first, int last) { selector_.look(present_, first, last); });
    selector_.choose(present_, reprojection_.staleness(), newSamples, number_, threads);
    const auto begun = std::chrono::steady_clock::now();
    if (!lightSamples(view, control, frame)) return false;
    sampleSeconds_ =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count() - otherSeconds_;
    reconstruction_.show(present_, threads, frame);
    meter(threads, frame);
    std::swap(past_, present_);
    ++number_;
    return true;
}

/// Where samples of one are seen by the other, pixels would show too few of them or too many.
void LiveRenderer::forgetOtherProjection(const ImagePlane& plane) {
    if (!empty() && past_.surface.plane().parallel != plane.parallel) forget();
}

/// The samples of the past that are still seen, in the view of `present_`.
void LiveRenderer::reproject(const RayTracer& tracer, int threads, const Reprojection::RowsDone& done) {
    entering_.find(past_.surface.plane(), present_.surface.plane(), tracer, threads);
    reprojection_.reproject(past_, present_, threads, [&](int first, int last) {
        entering_.forgetHidden(present_, first, last);
        done(first, last);
    });
}

void LiveRenderer::seed(const ImagePlane& plane, const Frame& frame, int threads, std::uint8_t age) {
    forgetChecks();
    past_.surface.resize(plane);
    const auto forEachPart = [&](auto&& work) {
        forEachRows(plane.height, kRowsOfPart, threadsFor(threads), work);
    };
    std::atomic<bool> anyMirrors = false;
    forEachPart([&](int first, int last) {
        const std::span part =
            std::span(frame.seen)
                .subspan(past_.surface.index(0, first), past_.surface.index(0, last - first));
        if (!anyMirrors && std::ranges::any_of(part, mirrors)) anyMirrors = true;
    });
    past_.mirrors = anyMirrors;
    if (past_.mirrors) past_.resizeSpecular(plane);
    past_.updatesLight = !frame.matter.empty();
    if (past_.updatesLight) past_.surface.matter.resize(past_.surface.size());
    const Seeds seeds{.age = age, .depth = meanDepth(plane, frame.seen)};
    forEachPart([&](int first, int last) {
        setSamplesOf(frame, {0, first, plane.width, last - first}, seeds, past_);
    });
}

void LiveRenderer::seedParts(const View& view, const Frame& frame, std::span<const PixelArea> parts,
                             int threads) {
    forgetOtherProjection(planeOf(view));
    present_.mirrors = past_.mirrors;
    present_.updatesLight = past_.updatesLight;
    present_.resize(planeOf(view));
    reproject(view.tracer, threadsFor(threads), [](int, int) {});
    const Seeds seeds{.depth = meanDepth(present_.surface)};
    if (!frame.matter.empty() && !present_.updatesLight) present_.beginUpdating();
    const auto mirrorsIn = [&](const PixelArea& part) {
        bool any = false;
        forEachPixel(part, [&](int x, int y) { any |= mirrors(frame.seen[present_.surface.index(x, y)]); });
        return any;
    };
    if (!present_.mirrors && std::ranges::any_of(parts, mirrorsIn)) beginMirroring();
    forEachPart(parts.size(), threadsFor(threads),
                [&](std::size_t i) { setSamplesOf(frame, parts[i], seeds, present_); });
    std::swap(past_, present_);
}

double LiveRenderer::invalidate(const LightChange& change, int threads) {
    LiveSamples& surface = past_.surface;
    const auto unknownOf = [&](std::size_t i) {
        if (past_.mirrors) past_.specular.forget(i);
        if (!surface.known(i)) return true;
        const bool mirrors = surface.mirrors(i),
                   reached = !surface.background(i) &&
                             change.reaches(surface.points[i].position, luminance(surface.light(i)));
        if (reached) surface.forget(i);
        return reached || mirrors;
    };
    std::atomic<std::size_t> unknown = 0;
    forEachRows(surface.plane().height, kRowsOfPart, threadsFor(threads), [&](int first, int last) {
        std::size_t here = 0;
        for (std::size_t i = surface.index(0, first); i < surface.index(0, last); ++i)
            here += unknownOf(i) ? 1U : 0U;
        unknown += here;
    });
    return surface.size() > 0 ? static_cast<double>(unknown) / static_cast<double>(surface.size()) : 1;
}

/// Adds a specular layer, of which no sample is known yet.
void LiveRenderer::beginMirroring() {
    const ImagePlane& plane = present_.surface.plane();
    present_.mirrors = true;
    present_.resizeSpecular(plane);
    present_.specular.clear(plane);
}

bool LiveRenderer::canReuse(const View& view) {
    if (empty()) return true;
    const ImagePlane before = past_.surface.plane(), now = planeOf(view);
    if (before.parallel != now.parallel) return false;
    if (!now.parallel) return !isFar(now.eye) && !crossesSurface(now.eye, view.tracer);
    return isAlike(before, now) && showsHalf(past_.surface, now) &&
           !entering_.coverHalf(before, now, view.tracer);
}

bool LiveRenderer::isFar(Vec3 eye) const {
    constexpr float kMax = 0.25F; // of how far away things are
    constexpr std::size_t kEvery = 97;
    const LiveSamples& surface = past_.surface;
    const Vec3 before = surface.plane().eye;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < surface.size(); i += kEvery) {
        if (!surface.known(i) || surface.background(i)) continue;
        sum += std::log(static_cast<double>(length(surface.points[i].position - before)) + 1e-30);
        ++count;
    }
    if (count == 0) return false; // all that was seen is endlessly far away
    return !(length(eye - before) < kMax * static_cast<float>(std::exp(sum / count)));
}

bool LiveRenderer::crossesSurface(Vec3 eye, const RayTracer& tracer) {
    const Vec3 before = past_.surface.plane().eye;
    if (eye == before) return false;
    eyePath_.clear();
    eyePath_.push({before, 0, eye - before, 1});
    tracer.occluded(RayKind::Shadow, eyePath_, crossed_);
    return crossed_[0] != 0;
}

/// The known visibility of lights at a pixel, without lights on which the samples around disagree: edges of
/// shadows stay where they are. In turns nothing counts as known, so that no error lasts.
LightVisibility LiveRenderer::surelyKnown(int x, int y) const {
    constexpr std::uint32_t kDoubted = 64; // in every such frame
    const LiveSamples& surface = present_.surface;
    const std::size_t at = surface.index(x, y);
    if (!surface.known(at) || (turnOf(x, y) + number_) % kDoubted == 0) return {};
    const ImagePlane& plane = surface.plane();
    unsigned clear = 0, dark = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, plane.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, plane.width - 1); ++u) {
            if (!surface.known(surface.index(u, v))) return {};
            const LightVisibility there = surface.lights[surface.index(u, v)].lights;
            clear |= there.clear;
            dark |= there.dark;
        }
    }
    const unsigned sure = ~(clear & dark);
    const LightVisibility here = surface.lights[at].lights;
    return {here.clear & sure, here.dark & sure};
}

bool LiveRenderer::lightSamples(const View& view, RenderControl& control, Frame& frame) {
    const std::vector<SampleId>& chosen = selector_.chosen();
    light_.resize(chosen.size());
    visibility_.resize(chosen.size());
    seen_.resize(chosen.size());
    const int threads = threadsFor(control.threads);
    forEachChosen(chosen.size(), threads,
                  [&](std::size_t i) { visibility_[i] = surelyKnown(chosen[i].x, chosen[i].y); });
    newSamples_ = static_cast<double>(chosen.size()) / static_cast<double>(present_.surface.size());
    if (!renderer_.renderPixels(view, chosen, control, {light_, visibility_, seen_}, frame.statistics))
        return false;
    otherSeconds_ = 0;
    if (indirect_ != nullptr && !addIndirect(view, control)) return false;
    const ImagePlane& plane = present_.surface.plane();
    if (!present_.mirrors && std::any_of(seen_.begin(), seen_.end(), mirrors)) beginMirroring();
    check();
    const float depth = meanDepth(present_.surface);
    forEachChosen(chosen.size(), threads, [&](std::size_t i) {
        const int x = chosen[i].x, y = chosen[i].y;
        setSamples(present_, present_.surface.index(x, y), seen_[i],
                   {.position = seen_[i].any ? seen_[i].position : backgroundAt(plane, x, y, depth),
                    .light = light_[i],
                    .lights = visibility_[i]});
        if (indirect_ != nullptr) present_.surface.matter[present_.surface.index(x, y)] = matter_[i];
        selector_.traced(plane, x, y, luminance(light_[i]));
    });
    updateBackground(view, threads);
    return true;
}

/// All of a parallel view's background lies in one direction. When that turns, a new sample tells of all.
void LiveRenderer::updateBackground(const View& view, int threads) {
    LiveSamples& surface = present_.surface;
    const ImagePlane& plane = surface.plane();
    if (!plane.parallel || plane.axis == past_.surface.plane().axis) return;
    if (fogMedium(view.scene, view.settings).on) return; // it differs from point to point
    const auto found = std::ranges::find_if(seen_, [](const SeenPoint& seen) { return !seen.any; });
    if (found == seen_.end()) return;
    const Colour light = light_[static_cast<std::size_t>(found - seen_.begin())];
    forEachRows(plane.height, kRowsOfPart, threads, [&](int first, int last) {
        forEachPixel({0, first, plane.width, last - first}, [&](int x, int y) {
            const std::size_t i = surface.index(x, y);
            if (!surface.known(i) || !surface.background(i)) return;
            surface.lights[i].radiance = packLight(light);
            selector_.traced(plane, x, y, luminance(light));
        });
    });
}

void LiveRenderer::lightIndirectly(IndirectLight* light, const GatherBudget& budget, int turns) {
    indirect_ = light;
    budget_ = budget;
    turns_ = turns;
    renderer_.lightIndirectlyFrom(light);
}

/// To the chosen pixels, and to the samples whose turn it is. Returns false when control.cancel was set.
bool LiveRenderer::addIndirect(const View& view, RenderControl& control) {
    const auto begun = std::chrono::steady_clock::now();
    const int threads = threadsFor(control.threads);
    collectReceivers(view);
    arriving_.resize(receivers_.size());
    if (!indirect_->step(receivers_, arriving_, budget_, threads, &control.cancel)) return false;
    alongLobes_.resize(renderer_.lobes().size());
    indirect_->learnLobes(renderer_.lobes(), alongLobes_, budget_.lobePaths(), threads);
    addToChosen();
    addAlongLobes();
    findFractions();
    updateLight(threads);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const double learning = indirect_->learned().seconds;
    const double old = receivers_.empty()
                           ? 0
                           : static_cast<double>(updated_.size()) / static_cast<double>(receivers_.size());
    const double following = indirect_->learned().secondsOfEdits;
    otherSeconds_ = learning + following + (seconds - learning - following) * old;
    return true;
}

/// Squares of pixels are updated together: the same records tell of them.
void LiveRenderer::collectReceivers(const View& view) {
    constexpr int kSide = 8;
    receivers_.clear();
    for (const IndirectTap& tap : renderer_.taps()) receivers_.push_back(tap.receiver);
    updated_.clear();
    const LiveSamples& surface = present_.surface;
    const ImagePlane& plane = surface.plane();
    const PixelSize pixel = pixelSizeOf(CameraRays(view.camera, plane.width, plane.height));
    const auto turns = static_cast<std::uint32_t>(turns_);
    const auto add = [&](int x, int y) {
        const std::size_t at = surface.index(x, y);
        if (!surface.known(at) || surface.background(at) || surface.matter[at].albedo == 0) return;
        const Vec3 position = surface.points[at].position;
        updated_.push_back(static_cast<std::uint32_t>(at));
        receivers_.push_back({position, unpackDirection(surface.matter[at].face),
                              unpackDirection(surface.matter[at].normal),
                              pixel.at(length(position - plane.eye))});
    };
    for (int top = 0; top < plane.height; top += kSide) {
        for (int left = 0; left < plane.width; left += kSide) {
            if (turnOf(left / kSide, top / kSide) * turns / kTurns != number_ % turns) continue;
            forEachPixel(
                {left, top, std::min(kSide, plane.width - left), std::min(kSide, plane.height - top)}, add);
        }
    }
}

/// What is seen in mirrors and through glass belongs to another layer.
void LiveRenderer::addToChosen() {
    const std::span<const IndirectTap> taps = renderer_.taps();
    surfaceLight_.resize(light_.size());
    matter_.assign(light_.size(), {});
    for (std::size_t i = 0; i < light_.size(); ++i) {
        surfaceLight_[i] = light_[i] * seen_[i].surfaceFraction;
        matter_[i].direct = packLight(surfaceLight_[i]);
    }
    for (std::size_t k = 0; k < taps.size(); ++k) {
        const IndirectTap& tap = taps[k];
        const Colour light = tap.light(arriving_[k].irradiance);
        light_[tap.sample] += light;
        const bool oneLayer = seen_[tap.sample].specularDistance == 0;
        if (tap.primary || oneLayer) surfaceLight_[tap.sample] += light;
        LiveSamples::Matter& matter = matter_[tap.sample];
        if (tap.primary && matter.albedo == 0) {
            matter.albedo = packLight(tap.factor);
            matter.normal = packDirection(tap.receiver.normal);
            matter.face = packDirection(tap.receiver.face);
        } else if (oneLayer) {
            matter.direct = packLight(unpackLight(matter.direct) + light);
        }
    }
}

/// It moves as what is mirrored does, where something is; else it stays with the surface.
void LiveRenderer::addAlongLobes() {
    const std::span<const LobeTap> lobes = renderer_.lobes();
    for (std::size_t k = 0; k < lobes.size(); ++k) {
        const std::uint32_t sample = lobes[k].sample;
        const Colour light = lobes[k].factor * alongLobes_[k];
        light_[sample] += light;
        if (seen_[sample].specularDistance != 0) continue;
        surfaceLight_[sample] += light;
        matter_[sample].direct = packLight(unpackLight(matter_[sample].direct) + light);
    }
}

void LiveRenderer::findFractions() {
    const auto partOf = [](float surface, float all) { return surface < all ? surface / all : 1; };
    for (std::size_t i = 0; i < light_.size(); ++i) {
        if (seen_[i].specularDistance == 0) continue;
        const Colour surface = surfaceLight_[i], all = light_[i];
        seen_[i].surfaceFraction = {partOf(surface.r, all.r), partOf(surface.g, all.g),
                                    partOf(surface.b, all.b)};
    }
}

void LiveRenderer::updateLight(int threads) {
    const std::size_t before = renderer_.taps().size();
    forEachChosen(updated_.size(), threads, [&](std::size_t k) {
        const LiveSamples::Matter& matter = present_.surface.matter[updated_[k]];
        const Colour light = unpackLight(matter.albedo) * arriving_[before + k].irradiance / kPi;
        present_.surface.lights[updated_[k]].radiance = packLight(unpackLight(matter.direct) + light);
    });
}

void LiveRenderer::forgetChecks() {
    for (std::vector<CheckedPixel>& checked : checked_) checked.clear();
}

/// Compares new samples with those they replace: stale light may be brighter or darker than the truth, and
/// the exposure must not follow it. To be called before they are replaced.
void LiveRenderer::check() {
    const ImagePlane& plane = present_.surface.plane();
    std::vector<CheckedPixel>& checked = checked_[number_ % kCheckedFrames];
    checked.clear();
    for (const PixelSelector::Check& check : selector_.checked()) {
        const SampleId pixel = selector_.chosen()[check.chosen];
        const float traced = luminance(light_[check.chosen]),
                    kept = selector_.luminances(plane, pixel.y)[pixel.x];
        const auto covered = [](bool is) -> std::uint8_t { return is ? 255 : 0; };
        const std::uint8_t tracedCovered = covered(seen_[check.chosen].any);
        if (check.blind && kept >= 0) {
            const bool background = present_.surface.background(present_.surface.index(pixel.x, pixel.y));
            checked.push_back({kept, traced, covered(!background), tracedCovered});
        } else {
            checked.push_back({traced, traced, tracedCovered, tracedCovered});
        }
    }
}

/// Measures the exposure on samples, not on the reconstructed image: that has fewer black pixels, so its
/// log-average differs. Pixels without a sample count as those before them.
void LiveRenderer::meter(int threads, Frame& frame) const {
    const LiveSamples& surface = present_.surface;
    frame.metered.resize(surface.size());
    forEachRows(surface.plane().height, kRowsOfPart, threads, [&](int first, int last) {
        const std::size_t from = surface.index(0, first), to = surface.index(0, last);
        std::size_t known = from;
        while (known < to && !present_.known(known)) ++known;
        float there = -1;
        std::uint8_t covered = known < to && surface.background(known) ? 0 : 255;
        for (int y = first; y < last; ++y) {
            const std::span<const float> luminances = selector_.luminances(surface.plane(), y);
            const std::size_t row = surface.index(0, y);
            for (std::size_t x = 0; x < luminances.size(); ++x) {
                if (luminances[x] >= 0) {
                    there = luminances[x];
                    covered = surface.background(row + x) ? 0 : 255;
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
