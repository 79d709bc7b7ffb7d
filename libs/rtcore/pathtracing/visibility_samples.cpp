#include "rtcore/pathtracing/visibility_samples.h"

#include "rtcore/lights/emitters-inl.h"
#include "rtcore/lights/light_sample-inl.h"
#include "rtcore/pathtracing/visibility_cache-inl.h"
#include "rtcore/platform/task_errors.h"
#include "rtcore/platform/threads.h"
#include "rtcore/sampling/owen-inl.h"
#include "rtcore/shading/light/shadows.h"
#include "rtcore/shading/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

constexpr std::uint32_t kBounces = 3; ///< points of a path at most
constexpr int kMaxPasses = 8;         ///< of its surfaces that let light pass
constexpr std::size_t kPathsOfTask = 512;

constexpr std::uint32_t kFirstTries = VisibilityRows::kSide; ///< the rest follows what they found
constexpr std::uint32_t kTries = std::tuple_size_v<decltype(VisibilitySample::sky)>;

/// Uses of random numbers, as nameOfUse() takes them; more follow the first.
enum : std::uint32_t { kUseOfFirstTries, kUseOfLaterTries, kUseOfLights, kUseOfScattering };

OwenPair randomPair(std::uint32_t number, std::uint32_t use) { return owenPair(number, nameOfUse(0, use)); }

/// A direction around a unit vector, by the cosine.
Vec3 cosineDirection(Vec3 normal, OwenPair random) {
    const auto basis = basisAround(normal);
    const auto disc = plain::onDisc<float>(unitFloat(random.u), unitFloat(random.v));
    const float up = std::sqrt(std::max(1 - disc.x * disc.x - disc.y * disc.y, 0.0F));
    return basis.tangent * disc.x + basis.bitangent * disc.y + normal * up;
}

std::uint8_t wholeNumber(float fraction) {
    if (!(fraction > 0)) return 0; // or no number
    return static_cast<std::uint8_t>(std::min(fraction, 1.0F) * VisibilitySample::kAll + 0.5F);
}

/// A ray to a light.
struct ToLight {
    Vec3 direction;
    float distance = 0;     ///< that is to be free
    bool shines = false;    ///< its light arrives there if it is
    bool surrounds = false; ///< where caustics count, glass is opaque to it (PathIntegrator::isSurrounding())
};
ToLight toLight(const Light& light, Vec3 point, Vec3 normal, OwenPair random) {
    return forKind(light.kind, [&]<LightKind kind>() {
        const auto sample =
            plain::sampleLight<kind, float>(light, point, {unitFloat(random.u), unitFloat(random.v), 1, 0});
        const float arriving =
            luminance(Colour{sample.irradiance.x, sample.irradiance.y, sample.irradiance.z});
        return ToLight{sample.toLight, sample.free, arriving > 0 && dot(normal, sample.toLight) > 0,
                       isDisc(light) || isMirrored(light)};
    });
}
ToLight toEmitter(const EmitterRows& emitters, std::uint32_t cluster, Vec3 point, Vec3 normal,
                  OwenPair random) {
    const auto sample = plain::sampleEmitter<float>(emitters, unitFloat(random.u), unitFloat(random.v),
                                                    mixBits(random.u ^ random.v), cluster);
    const Vec3 offset = sample.position - point;
    const float distance = length(offset);
    if (!(distance > 0) || !isFinite(offset)) return {};
    const Vec3 direction = offset / distance;
    return {direction, distance * 0.9999F, dot(normal, direction) > 0, true};
}

/// A light of a node, by intensity.
std::uint32_t leafOf(const LightTreeRows& tree, std::uint32_t node, std::uint32_t random) {
    while ((tree.nodes[node].kind & light_node::kLeaf) == 0) {
        const std::uint32_t first = node + 1, second = tree.nodes[node].next;
        const float a = tree.nodes[first].intensity, b = tree.nodes[second].intensity;
        random = mixBits(random);
        node = unitFloat(random) * (a + b) < a ? first : second;
    }
    return tree.nodes[node].next;
}

/// Follows some paths; one for each thread.
class Follower {
  public:
    explicit Follower(const VisibilityTask& task)
        : task_(task), lights_(task.lights.rows()), emitters_(task.lights.emitters().rows()),
          candidates_(lights_.lightCandidates() + lights_.emitterCandidates()),
          surroundings_(task.lights.surroundings().rows()) {
        straight_.begin(task.scene, task.tracer, task.settings, task.materials.clear());
        RenderSettings opaque = task.settings;
        opaque.refractions = opaque.refractions && !opaque.path.caustics;
        ofSky_.begin(task.scene, task.tracer, opaque, task.materials.clear());
    }

    /// The points of the camera's rays first..last - 1.
    void follow(const RayWave& camera, std::size_t first, std::size_t last,
                std::vector<VisibilitySample>& samples) {
        now_.clear();
        paths_.clear();
        for (std::size_t i = first; i < last; ++i) {
            now_.push(camera.ray(i));
            paths_.push_back({static_cast<std::uint32_t>(i), 0, 0});
        }
        while (!now_.empty()) {
            const std::size_t before = samples.size();
            step(samples);
            look(std::span(samples).subspan(before));
        }
    }

    /// More directions for samples, where light arrives.
    void lookAgain(const VisibilityRows& known, std::span<VisibilitySample> samples) {
        startTests();
        for (VisibilitySample& sample : samples) {
            const std::uint32_t cell = plain::cellOf<float>(known, sample.position, sample.normal);
            for (std::uint32_t k = kFirstTries; k < kTries; ++k) {
                const OwenPair random = randomPair(sample.number * kTries + k, kUseOfLaterTries);
                trySky(sample, k, plain::visibleNumbers<float>(known, cell, random.u, random.v));
            }
        }
        endTests(ofSky_);
    }

  private:
    struct Path {
        std::uint32_t number;
        std::uint32_t bounces;
        int passes;
    };

    /// One surface further: those that stop light become samples.
    void step(std::vector<VisibilitySample>& samples) {
        task_.tracer.intersect(RayKind::Scattered, now_, hits_);
        next_.clear();
        nextPaths_.clear();
        for (std::size_t i = 0; i < now_.size(); ++i) {
            if (!hits_.isHit(i)) continue;
            Path path = paths_[i];
            const Hit hit = hits_.hit(i);
            const Ray ray = now_.ray(i);
            const Surface surface = shapeAt(task_.scene, ray.direction, hit, hits_.clearanceOf(i));
            if (letsPass(hit)) {
                if (++path.passes > kMaxPasses) continue;
                go(surface.position - surface.geometricNormal * surface.clearance, ray.direction, path);
                continue;
            }
            VisibilitySample sample;
            sample.position = surface.position + surface.geometricNormal * surface.clearance;
            sample.normal = surface.shadingNormal;
            sample.number = path.number * kBounces + path.bounces;
            samples.push_back(sample);
            if (++path.bounces == kBounces) continue;
            const Vec3 direction = cosineDirection(surface.geometricNormal,
                                                   randomPair(path.number, kUseOfScattering + path.bounces));
            go(sample.position, direction, path);
        }
        std::swap(now_, next_);
        std::swap(paths_, nextPaths_);
    }
    bool letsPass(const Hit& hit) const {
        const std::span<const std::uint8_t> clear = task_.materials.clear();
        const std::uint32_t material = task_.scene.mesh().shading[hit.triangle].material;
        return material < clear.size() && clear[material] != 0;
    }
    void go(Vec3 origin, Vec3 direction, const Path& path) {
        next_.push({origin, 0, direction, std::numeric_limits<float>::infinity()});
        nextPaths_.push_back(path);
    }

    /// What points see.
    void look(std::span<VisibilitySample> samples) {
        if (!task_.lights.surroundings().empty()) lookAtSky(samples);
        for (VisibilitySample& sample : samples) sample.light.fill(VisibilitySample::kUntried);
        if (candidates_ > 0) lookAtLights(samples);
    }

    /// One direction in each row of bins.
    void lookAtSky(std::span<VisibilitySample> samples) {
        startTests();
        for (VisibilitySample& sample : samples) {
            for (std::uint32_t row = 0; row < kFirstTries; ++row) {
                const OwenPair random = randomPair(sample.number * kFirstTries + row, kUseOfFirstTries);
                trySky(sample, row, {random.u, row << 28 | random.v >> 4});
            }
        }
        endTests(ofSky_);
    }
    void trySky(VisibilitySample& sample, std::size_t k, const plain::VisibleNumbers<float>& numbers) {
        const Vec3 direction =
            plain::environmentDirection<float>(surroundings_, numbers.across, numbers.down);
        const float cosine = dot(direction, sample.normal);
        sample.sky[k] = {static_cast<std::uint8_t>(numbers.down >> 28 << 4 | numbers.across >> 28), 0};
        if (cosine > 0)
            test(sample.position, direction, std::numeric_limits<float>::max(), cosine, sample.sky[k].seen);
    }

    void lookAtLights(std::span<VisibilitySample> samples) {
        const std::size_t all = candidates_;
        const auto tried = static_cast<std::uint32_t>(std::min<std::size_t>(all, VisibilitySample::kLights));
        for (const bool surrounding : {false, true}) {
            startTests();
            for (VisibilitySample& sample : samples) {
                for (std::uint32_t k = 0; k < tried; ++k) {
                    const auto candidate = static_cast<std::uint32_t>(sample.lightOf(k, all));
                    const OwenPair random =
                        randomPair(sample.number * VisibilitySample::kLights + k, kUseOfLights);
                    const ToLight to = toCandidate(candidate, sample, random);
                    if (to.shines && to.surrounds == surrounding)
                        test(sample.position, to.direction, to.distance, 1, sample.light[k]);
                }
            }
            endTests(surrounding ? ofSky_ : straight_);
        }
    }
    ToLight toCandidate(std::uint32_t candidate, const VisibilitySample& from, OwenPair random) const {
        const std::uint32_t bits = mixBits(random.u + random.v);
        if (candidate < lights_.lightCandidates()) {
            const std::uint32_t light =
                lights_.byTree() ? leafOf(lights_.tree, lights_.tree.cut[candidate], bits) : candidate;
            return toLight(lights_.light[light], from.position, from.normal, random);
        }
        const LightTreeRows& tree = lights_.emitterTree;
        const std::uint32_t cluster =
            lights_.emittersByTree() ? leafOf(tree, tree.cut[candidate - lights_.lightCandidates()], bits)
                                     : 0;
        return toEmitter(emitters_, cluster, from.position, from.normal, random);
    }

    struct Test {
        std::uint8_t* to;
        float all;
    };
    void startTests() {
        rays_.clear();
        tests_.clear();
    }
    void test(Vec3 origin, Vec3 direction, float distance, float all, std::uint8_t& to) {
        rays_.push({origin, 0, direction, distance});
        tests_.push_back({&to, all});
    }
    /// Sets each number to all of it, times what arrives.
    void endTests(ShadowTracer& tracer) {
        if (rays_.empty()) return;
        if (tracer.tinted()) {
            const std::vector<Colour>& arriving = tracer.transmittance(rays_, statistics_);
            for (std::size_t i = 0; i < tests_.size(); ++i)
                *tests_[i].to = wholeNumber(tests_[i].all * luminance(arriving[i]));
        } else {
            const std::vector<std::uint8_t>& occluded = tracer.occluded(rays_, statistics_);
            for (std::size_t i = 0; i < tests_.size(); ++i)
                *tests_[i].to = occluded[i] != 0 ? std::uint8_t{0} : wholeNumber(tests_[i].all);
        }
    }

    const VisibilityTask& task_;
    const LightRows lights_;
    const EmitterRows emitters_;
    const std::size_t candidates_; ///< but the surroundings
    EnvironmentRows surroundings_;
    ShadowTracer straight_, ofSky_;
    RayStatistics statistics_;
    RayWave now_, next_, rays_;
    std::vector<Path> paths_, nextPaths_;
    HitWave hits_;
    std::vector<Test> tests_;
};

/// Calls use(follower, k) for k = 0..tasks - 1, in several threads.
template <typename Use>
void followAll(const VisibilityTask& task, std::size_t tasks, Use&& use) {
    TaskErrors errors;
#pragma omp parallel num_threads(threadsFor(task.threads))
    errors.guard([&] {
        Follower follower(task);
#pragma omp for schedule(dynamic, 1) nowait
        for (std::size_t k = 0; k < tasks; ++k) {
            if (task.stopped() || errors.any()) continue;
            errors.guard([&] { use(follower, k); });
        }
    });
    errors.rethrow();
}

} // namespace

VisibilityCache learnVisibility(const VisibilityTask& task, const RayWave& camera) {
    const std::size_t tasks = (camera.size() + kPathsOfTask - 1) / kPathsOfTask;
    std::vector<std::vector<VisibilitySample>> found(tasks);
    followAll(task, tasks, [&](Follower& follower, std::size_t k) {
        const std::size_t first = k * kPathsOfTask;
        follower.follow(camera, first, std::min(camera.size(), first + kPathsOfTask), found[k]);
    });
    const LightRows lights = task.lights.rows();
    const std::size_t candidates = lights.lightCandidates() + lights.emitterCandidates();
    VisibilityCache cache;
    const auto build = [&](std::size_t tries) {
        std::vector<VisibilitySample> all;
        for (const std::vector<VisibilitySample>& some : found)
            all.insert(all.end(), some.begin(), some.end());
        cache.build(all, tries, candidates, task.lights.surroundings().scalarIrradiance());
    };
    if (task.lights.surroundings().empty()) {
        build(0);
        return cache;
    }
    build(kFirstTries);
    if (cache.empty()) return cache;
    followAll(task, tasks,
              [&](Follower& follower, std::size_t k) { follower.lookAgain(cache.rows(), found[k]); });
    build(kTries);
    return cache;
}

} // namespace rtcore
