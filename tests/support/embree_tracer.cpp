#include "support/embree_tracer.h"

#include "support/embree_scene.h"
#include "support/embree_waves.h"

#include <utility>

namespace test {

namespace {

std::string embreeName(const std::string& instructionSet) {
    if (instructionSet == "sse4") return "sse4.2";
    if (instructionSet == "scalar") return "sse2"; // the least that Embree has
    return instructionSet == "neon" ? "" : instructionSet;
}

RayArrays arraysOf(const rtcore::RayWave& rays) {
    return {rays.ox.data(), rays.oy.data(),   rays.oz.data(),   rays.dx.data(), rays.dy.data(),
            rays.dz.data(), rays.tMin.data(), rays.tMax.data(), rays.size()};
}

} // namespace

std::string embreeVersion() { return "Embree " RTC_VERSION_STRING; }

int embreeWidth(const std::string& instructionSet) {
    if (instructionSet == "avx512") return 16;
    return instructionSet == "avx2" ? 8 : 4;
}

std::size_t embreeMemory(const EmbreeScene& scene) { return scene.memory(); }

std::shared_ptr<const EmbreeScene> makeEmbreeScene(const rtcore::Mesh& mesh, EmbreeQuality quality,
                                                   const std::string& instructionSet) {
    EmbreeBuild build;
    build.flags = quality == EmbreeQuality::Robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE;
    build.quality = quality == EmbreeQuality::High ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
    build.threads = 0;
    build.isa = embreeName(instructionSet);
    return std::make_shared<const EmbreeScene>(mesh, build);
}

EmbreeTracer::EmbreeTracer(std::shared_ptr<const EmbreeScene> scene, int width, EmbreeCoherence coherence)
    : scene_(std::move(scene)), width_(width), coherence_(coherence) {}

bool EmbreeTracer::coherent(rtcore::RayKind kind) const {
    if (coherence_ != EmbreeCoherence::ByKind) return coherence_ == EmbreeCoherence::Coherent;
    return kind == rtcore::RayKind::Primary || kind == rtcore::RayKind::Shadow;
}

void EmbreeTracer::intersect(rtcore::RayKind kind, const rtcore::RayWave& rays, rtcore::HitWave& hits) const {
    hits.resize(rays.size());
    intersectWave(scene_->handle(), coherent(kind), width_, arraysOf(rays),
                  {hits.t.data(), hits.u.data(), hits.v.data(), hits.triangle.data()});
}

void EmbreeTracer::occluded(rtcore::RayKind kind, const rtcore::RayWave& rays,
                            std::vector<std::uint8_t>& occluded) const {
    occluded.resize(rays.size());
    occludedWave(scene_->handle(), coherent(kind), width_, arraysOf(rays), occluded.data());
}

rtcore::Box3 EmbreeTracer::bounds() const {
    RTCBounds b{};
    rtcGetSceneBounds(scene_->handle(), &b);
    return {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
}

} // namespace test
