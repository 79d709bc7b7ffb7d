#include "rtcore/gathering/emitter_rays.h"

#include "rtcore/lights/emitters-inl.h"
#include "rtcore/lights/light_tree-inl.h"
#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/shading/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

constexpr std::uint32_t kRays = 16; ///< of a pass

struct ChosenCluster {
    std::uint32_t number = 0;
    float probability = 1;
};

/// A cluster by what it may throw on the point. `u`: 0..1, without 1.
ChosenCluster chooseCluster(const LightTreeRows& tree, Vec3 point, Vec3 normal, float u) {
    ChosenCluster chosen;
    if (tree.nodes == nullptr) return chosen;
    std::uint32_t node = 0;
    while ((tree.nodes[node].kind & light_node::kLeaf) == 0) {
        const std::uint32_t first = node + 1, second = tree.nodes[node].next;
        const float p =
            plain::probabilityOfFirst<float>(tree.directed, plain::broadcastNode<float>(tree.nodes[first]),
                                             plain::broadcastNode<float>(tree.nodes[second]), point, normal);
        const bool goesFirst = u < p;
        u = std::clamp(goesFirst ? u / p : (u - p) / (1 - p), 0.0F, 1.0F - 0x1p-24F);
        chosen.probability *= goesFirst ? p : 1 - p;
        node = goesFirst ? first : second;
    }
    chosen.number = tree.nodes[node].next;
    return chosen;
}

} // namespace

void EmitterRays::add(const PathFrame& paths, std::span<const GatherPass> passes, int threads,
                      std::span<PassLight> light) {
    constexpr std::size_t kPasses = 64; // of a wave
    if (paths.lights.emitters().empty()) return;
    const int team = threadsFor(threads);
    while (workers_.size() < static_cast<std::size_t>(team)) workers_.push_back(std::make_unique<Worker>());
    RenderSettings settings = paths.settings;
    settings.refractions = settings.refractions && !settings.path.caustics; // rays find what is behind glass
    for (const auto& worker : workers_)
        worker->shadows.begin(paths.scene, paths.tracer, settings, paths.materials.clear());
    forEachPart((passes.size() + kPasses - 1) / kPasses, team, [&](std::size_t part) {
        Worker& worker = *workers_[static_cast<std::size_t>(threadNumber())];
        const std::size_t first = part * kPasses, last = std::min(first + kPasses, passes.size());
        worker.rays.clear();
        worker.radiance.clear();
        for (std::size_t i = first; i < last; ++i) aim(paths, passes[i], worker);
        if (!settings.shadows) {
            // nothing is in the way
        } else if (worker.shadows.tinted()) {
            const std::vector<Colour>& arriving =
                worker.shadows.transmittance(worker.rays, worker.statistics);
            for (std::size_t i = 0; i < arriving.size(); ++i) worker.radiance[i] *= arriving[i];
        } else {
            const std::vector<std::uint8_t>& occluded =
                worker.shadows.occluded(worker.rays, worker.statistics);
            for (std::size_t i = 0; i < occluded.size(); ++i)
                if (occluded[i] != 0) worker.radiance[i] = {};
        }
        for (std::size_t i = 0; i < worker.rays.size(); ++i) {
            const std::size_t pass = first + i / kRays;
            const Vec3 direction = worker.rays.ray(i).direction;
            light[pass].add(worker.radiance[i], direction, dot(direction, passes[pass].normal), 1.0F / kRays);
        }
    });
}

/// Adds the rays of a pass, and the irradiance that each would be alone if nothing was in its way.
void EmitterRays::aim(const PathFrame& paths, const GatherPass& pass, Worker& worker) {
    const EmitterRows emitters = paths.lights.emitters().rows();
    for (std::uint32_t k = 0; k < kRays; ++k) {
        const std::uint32_t number = pass.number * kRays + k;
        const auto pairFor = [&](SampleDimension dimension) {
            return owenPair(number, nameOfUse(pass.name, useBits(dimension, 0)));
        };
        const OwenPair point = pairFor(SampleDimension::AreaLight),
                       choice = pairFor(SampleDimension::Emitter);
        const ChosenCluster cluster =
            chooseCluster(emitters.tree, pass.origin, pass.normal, unitFloat(choice.u));
        const auto sample = plain::sampleEmitter<float>(emitters, unitFloat(point.u), unitFloat(point.v),
                                                        choice.v, cluster.number);
        const Vec3 offset = sample.position - pass.origin;
        const float square = dot(offset, offset), distance = std::sqrt(square);
        const Vec3 direction = distance > 0 ? offset / distance : pass.normal;
        const float leaving = std::fabs(dot(direction, sample.normal)),
                    arriving = dot(direction, pass.normal);
        const float irradiance = arriving * leaving / (square * sample.density * cluster.probability);
        const bool any = arriving > 0 && irradiance > 0 && std::isfinite(irradiance);
        worker.rays.push({pass.origin, 0, direction, any ? distance * 0.9999F : -1});
        worker.radiance.push_back(
            any ? emissionAt(paths.scene, paths.settings.textures, {0, sample.triangle, sample.u, sample.v}) *
                      irradiance
                : Colour{});
    }
}

} // namespace rtcore
