#include "rtcore/render/light_probe.h"

#include "rtcore/gathering/gather_rays.h"
#include "rtcore/pathtracing/visibility_samples.h"
#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/scene/part_list.h"
#include "rtcore/shading/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rtcore {

namespace {

/// Of a measurement: paths of a batch, and the batches that it begins with.
struct BatchPlan {
    std::uint32_t paths, min;
};
constexpr BatchPlan kThorough{256, 32}, kRough{64, 8};
constexpr std::uint32_t kWaveBatches = 8;    ///< traced together; divides the batches of a plan
constexpr std::uint32_t kMaxBatches = 65536; ///< whose numbers are names
constexpr int kBounces = 64;
/// Rays by which visibility is learned: of a point at most, and of all together.
constexpr std::size_t kLookedOfPoint = 512, kLooked = 4096;

constexpr const BatchPlan& planFor(const ProbeEffort& effort) {
    return effort.paths < kThorough.paths * kThorough.min ? kRough : kThorough;
}

RenderSettings measuringSettings(const RenderSettings& shown) {
    RenderSettings settings = shown;
    settings.shadows = settings.reflections = settings.refractions = true;
    settings.maxDepth = std::max(settings.maxDepth, 16);
    settings.path.bounces = kBounces;
    settings.path.clampIndirect = 0;
    return settings;
}

using Sum = std::array<double, 3>;

double luminanceOf(const Sum& c) {
    return double{kLuminance.r} * c[0] + double{kLuminance.g} * c[1] + double{kLuminance.b} * c[2];
}

} // namespace

/// A part of the light, prepared.
struct LightProbe::Part {
    const Scene* scene;
    double unit;
    RenderSettings settings; ///< with a seed of its own
    MaterialTable materials;
    LightSet lights;

    PathFrame frame(const RayTracer& tracer) const { return {*scene, tracer, settings, materials, lights}; }
};

/// Means of the batches of one target: of each its part's colours, in units of the result.
struct LightProbe::Sums {
    std::vector<std::vector<Sum>> batches; ///< by part
    std::uint32_t ofBatch = 0;             ///< paths

    MeasuredLight mean() const;
};

/// Points or rays.
struct LightProbe::Target {
    std::span<const WhitePoint> points;
    std::span<const Ray> rays;

    std::size_t size() const { return points.empty() ? rays.size() : points.size(); }
    double factor() const { return points.empty() ? 1 : std::numbers::pi; }
    /// Adds `count` paths of a batch of the i-th.
    void trace(std::size_t i, std::span<const SampleId> samples, PathIntegrator& integrator) const {
        if (points.empty()) {
            RayWave wave;
            for (std::size_t k = 0; k < samples.size(); ++k) wave.push(rays[i]);
            integrator.trace(wave, samples);
        } else {
            const std::vector<WhitePoint> wave(samples.size(), points[i]);
            integrator.traceWhite(wave, samples);
        }
    }
};

LightProbe::LightProbe() = default;
LightProbe::~LightProbe() = default;

MeasuredLight LightProbe::Sums::mean() const {
    MeasuredLight result;
    const std::size_t count = batches.front().size();
    std::vector<double> whole(count);
    for (const std::vector<Sum>& part : batches) {
        Sum sum{};
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) sum[k] += part[i][k];
            whole[i] += luminanceOf(part[i]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            sum[k] /= static_cast<double>(count);
            result.colour[k] += sum[k];
        }
        result.parts.push_back(luminanceOf(sum));
        result.luminance += result.parts.back();
    }
    double squares = 0;
    for (const double batch : whole) squares += (batch - result.luminance) * (batch - result.luminance);
    result.error = std::sqrt(squares / (static_cast<double>(count) * static_cast<double>(count - 1)));
    result.paths = static_cast<std::uint32_t>(count) * ofBatch;
    return result;
}

void LightProbe::begin(std::span<const ProbedLight> parts, const RayTracer& tracer,
                       const RenderSettings& settings) {
    tracer_ = &tracer;
    settings_ = measuringSettings(settings);
    parts_.clear();
    for (const ProbedLight& each : parts) {
        auto part = std::make_unique<Part>(Part{each.scene, each.unit, settings_, {}, {}});
        const auto seed = static_cast<std::uint32_t>(settings_.path.seed);
        part->settings.path.seed =
            static_cast<int>(mixBits(seed + 0x9E3779B9U * static_cast<std::uint32_t>(parts_.size())) >> 1);
        part->materials.prepare(*each.scene, part->settings, Colour{});
        part->lights.prepare(*each.scene, part->settings, tracer.bounds(),
                             partTriangles(each.scene->model, each.scene->hiddenParts));
        parts_.push_back(std::move(part));
    }
}

bool LightProbe::irradiance(std::span<const WhitePoint> points, const ProbeEffort& effort,
                            RenderControl& control, std::vector<MeasuredLight>& measured) {
    return measure({points, {}}, effort, control, measured);
}

bool LightProbe::radiance(std::span<const Ray> rays, const ProbeEffort& effort, RenderControl& control,
                          std::vector<MeasuredLight>& measured) {
    return measure({{}, rays}, effort, control, measured);
}

bool LightProbe::measure(const Target& target, const ProbeEffort& effort, RenderControl& control,
                         std::vector<MeasuredLight>& measured) {
    measured.assign(target.size(), {});
    if (target.size() == 0 || parts_.empty()) return !control.cancel;
    if (!look(target, control)) return false;
    std::vector<Sums> sums(target.size());
    const BatchPlan& plan = planFor(effort);
    for (Sums& each : sums) {
        each.batches.resize(parts_.size());
        each.ofBatch = plan.paths;
    }
    std::vector<std::uint32_t> open(target.size());
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = static_cast<std::uint32_t>(i);
    const std::size_t all = open.size();
    control.tilesDone = 0;
    control.tiles = all;
    for (std::uint32_t batches = plan.min; !open.empty(); batches *= 2) {
        if (!addBatches(target, open, batches, control, sums)) return false;
        std::erase_if(open, [&](std::uint32_t i) {
            measured[i] = sums[i].mean();
            const bool known =
                effort.relativeError > 0 && measured[i].error <= effort.relativeError * measured[i].luminance;
            return known || measured[i].paths >= effort.paths || batches >= kMaxBatches;
        });
        control.tilesDone = all - open.size();
    }
    return !control.cancel;
}

/// Learns what the targets see of the lights, by rays that leave them.
bool LightProbe::look(const Target& target, RenderControl& control) {
    RayWave rays;
    if (target.points.empty()) {
        for (const Ray& ray : target.rays) rays.push(ray);
    } else {
        const std::size_t ofPoint = std::clamp(kLooked / target.size(), kPassRays, kLookedOfPoint);
        for (std::size_t i = 0; i < target.size(); ++i) {
            for (std::uint32_t pass = 0; pass < ofPoint / kPassRays; ++pass)
                addGatherRays({0, target.points[i].position, target.points[i].normal,
                               mixBits(static_cast<std::uint32_t>(i)), pass},
                              rays);
        }
    }
    for (const auto& part : parts_) {
        if (part->lights.surroundings().empty() && part->lights.rows().candidates() < 2) continue;
        part->lights.setVisibility(learnVisibility({*part->scene, *tracer_, part->settings, part->materials,
                                                    part->lights, control.threads, &control.cancel},
                                                   rays));
        if (control.cancel) return false;
    }
    return true;
}

/// Until the open targets have so many.
bool LightProbe::addBatches(const Target& target, std::span<const std::uint32_t> open, std::uint32_t batches,
                            RenderControl& control, std::vector<Sums>& sums) {
    const int team = threadsFor(control.threads);
    while (integrators_.size() < static_cast<std::size_t>(team))
        integrators_.push_back(std::make_unique<PathIntegrator>());
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const Part& part = *parts_[p];
        for (const auto& integrator : integrators_) {
            integrator->begin(part.frame(*tracer_));
            integrator->stopWhen(&control.cancel);
        }
        const std::size_t before = sums[open.front()].batches[p].size();
        for (const std::uint32_t i : open) sums[i].batches[p].resize(batches);
        const std::size_t waves = (batches - before) / kWaveBatches;
        const std::uint32_t ofBatch = sums[open.front()].ofBatch;
        const double scale = part.unit * target.factor() / ofBatch;
        forEachPart(open.size() * waves, team, [&](std::size_t task) {
            if (control.cancel.load(std::memory_order_relaxed)) return;
            PathIntegrator& integrator = *integrators_[static_cast<std::size_t>(threadNumber())];
            const std::size_t i = open[task / waves], first = before + task % waves * kWaveBatches;
            std::vector<SampleId> samples;
            for (std::size_t batch = first; batch < first + kWaveBatches; ++batch)
                for (std::uint32_t sub = 0; sub < ofBatch; ++sub)
                    samples.push_back(
                        {static_cast<std::uint16_t>(batch), static_cast<std::uint16_t>(i), sub});
            target.trace(i, samples, integrator);
            for (std::size_t k = 0; k < samples.size(); ++k) {
                const Colour found = integrator.radiance().colourAt(k);
                if (!isFinite(found)) continue; // numbers of the scene are not
                Sum& sum = sums[i].batches[p][first + k / ofBatch];
                const std::array<float, 3> channels{found.r, found.g, found.b};
                for (std::size_t c = 0; c < 3; ++c) sum[c] += scale * static_cast<double>(channels[c]);
            }
        });
    }
    return !control.cancel;
}

std::optional<WhitePoint> sideSeen(const Scene& scene, const RayTracer& tracer, const Ray& ray) {
    RayWave rays;
    HitWave hits;
    rays.push(ray);
    tracer.intersect(RayKind::Primary, rays, hits);
    if (!hits.isHit(0)) return std::nullopt;
    const Surface s = shapeAt(scene, ray.direction, hits.hit(0), hits.clearanceOf(0));
    return WhitePoint{s.position + s.geometricNormal * s.clearance, s.geometricNormal};
}

} // namespace rtcore
