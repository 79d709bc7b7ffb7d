/// Scenes that planes cut open: which rays are clipped, what they meet, and what light does.
#include "rtcore/kernels/section_clip.h"
#include "rtcore/render/path_renderer.h"
#include "rtcore/render/shown_tracer.h"
#include "support/random_numbers.h"
#include "support/rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace rtcore;

constexpr float kFar = std::numeric_limits<float>::max();

std::shared_ptr<const RayTracer> tracerOf(const test::TracedScene& s) {
    return shownTracer({&s.tracer, [](const auto*) {}}, s.scene);
}

struct Doubles {
    double x, y, z;
};
Doubles doubles(Vec3 p) { return {double{p.x}, double{p.y}, double{p.z}}; }
Doubles minus(Doubles a, Doubles b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dotOf(Doubles a, Doubles b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Doubles crossOf(Doubles a, Doubles b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// How far beyond the planes a point lies; below 0: it is left.
double beyond(const SectionPlanes& sections, Doubles point) {
    double farthest = -1e30;
    for (const SectionPlane& plane : sections.planes) {
        const Doubles n = doubles(plane.normal);
        farthest = std::max(farthest, dotOf(n, minus(point, doubles(plane.point))) / std::sqrt(dotOf(n, n)));
    }
    return farthest;
}

/// Of the 60 triangles of a soup the first 20 are a part, which sections may leave whole.
constexpr std::uint32_t kUncut = 20;

/// By all triangles, each cut by itself.
class CutTriangles {
  public:
    CutTriangles(const Scene& scene) : scene_(scene) {}

    /// The nearest distance; `sure` becomes false where a hit lies so near to a plane, or to an edge, that
    /// rounding decides.
    std::optional<double> nearest(const Ray& ray, bool& sure) const {
        std::optional<double> best;
        const Mesh& mesh = scene_.mesh();
        const Doubles o = doubles(ray.origin), d = doubles(ray.direction);
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const Doubles a = doubles(mesh.position(i, 0)), e = minus(doubles(mesh.position(i, 1)), a),
                          f = minus(doubles(mesh.position(i, 2)), a), p = crossOf(d, f);
            const double determinant = dotOf(e, p);
            if (std::fabs(determinant) < 1e-9) continue;
            const Doubles s = minus(o, a), q = crossOf(s, e);
            const double u = dotOf(s, p) / determinant, v = dotOf(d, q) / determinant;
            const double inside = std::min({u, v, 1 - u - v}), t = dotOf(f, q) / determinant;
            if (inside < -1e-4 || t < 0) continue;
            const double out = beyond(scene_.sections, {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z});
            const bool uncut = scene_.uncutParts != nullptr && i < kUncut;
            if (inside < 1e-4 || (!uncut && std::fabs(out) < 1e-4)) sure = false;
            if ((uncut || out < 0) && (!best || t < *best)) best = t;
        }
        return best;
    }

  private:
    const Scene& scene_;
};

SectionPlanes randomPlanes(test::Random& random, std::size_t count) {
    SectionPlanes sections;
    for (std::size_t i = 0; i < count; ++i)
        sections.planes.push_back({random.vector(1), random.unitVector() * random.number(0.1F, 3)});
    return sections;
}

test::TracedScene soup(test::Random& random, SectionPlanes sections, bool uncut) {
    test::SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(0.7F));
    for (int i = 0; i < 60; ++i) {
        const Vec3 first = random.vector(2), second = random.vector(2);
        b.triangle(first, second, random.vector(2), white);
    }
    b.buffers.parts = {{b.buffers.addName("first"), 0, kUncut}, {b.buffers.addName("rest"), kUncut, 40}};
    b.scene.sections = std::move(sections);
    if (uncut)
        b.scene.uncutParts =
            std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{1, 0});
    return test::TracedScene(b.finish());
}

/// RT_SECTION_RAYS: so many for each scene.
int raysOfScene() {
    const char* const text = std::getenv("RT_SECTION_RAYS"); // NOLINT(concurrency-mt-unsafe)
    return text != nullptr ? std::stoi(text) : 500;
}

/// What is found, by all kinds of rays that are clipped, and how much of it is sure.
struct Compared {
    int all = 0, sure = 0, hits = 0;

    void add(const RayTracer& tracer, const CutTriangles& truth, RayKind kind, const RayWave& rays) {
        HitWave found;
        std::vector<std::uint8_t> occluded;
        tracer.intersect(kind, rays, found);
        tracer.occluded(kind, rays, occluded);
        for (std::size_t i = 0; i < rays.size(); ++i, ++all) {
            bool decided = true;
            const auto nearest = truth.nearest(rays.ray(i), decided);
            if (!decided) continue;
            ++sure;
            ASSERT_EQ(found.isHit(i), nearest.has_value()) << all;
            ASSERT_EQ(occluded[i] != 0, nearest.has_value()) << all;
            if (!nearest) continue;
            ++hits;
            ASSERT_NEAR(double{found.t[i]}, *nearest, 1e-4 * std::max(1.0, *nearest)) << all;
        }
    }
};

TEST(Sections, RaysMeetWhatIsLeft) {
    constexpr int kWave = 100;
    constexpr std::array kKinds{RayKind::Primary, RayKind::Mirror, RayKind::Refracted};
    test::Random random(48);
    Compared compared;
    for (int round = 0; round < 12; ++round) {
        const test::TracedScene s =
            soup(random, randomPlanes(random, 1 + static_cast<std::size_t>(round) % 6), round % 3 == 2);
        const auto tracer = tracerOf(s);
        const CutTriangles truth(s.scene);
        for (int wave = 0; wave < raysOfScene() / kWave; ++wave) {
            RayWave rays;
            for (int i = 0; i < kWave; ++i) {
                const Vec3 from = random.vector(3), to = random.vector(3);
                rays.push({from, 0, to - from, kFar});
            }
            compared.add(*tracer, truth, kKinds[static_cast<std::size_t>(wave) % kKinds.size()], rays);
            if (HasFatalFailure()) return;
        }
    }
    RecordProperty("unsure", compared.all - compared.sure);
    EXPECT_GT(compared.sure, compared.all / 10 * 9);
    EXPECT_GT(compared.hits, compared.all / 10);
}

TEST(Sections, ClipTheRaysOfTheCameraAloneWhereLightIsWhole) {
    test::SceneBuilder b = test::block();
    b.scene.sections.planes = {{{0, 0, 0}, {0, 1, 0}}};
    test::TracedScene s(b.finish());
    RayWave down;
    down.push({{0.2F, 3, 0.1F}, 0, {0, -1, 0}, kFar});
    const auto met = [&](RayKind kind) {
        HitWave hit;
        tracerOf(s)->intersect(kind, down, hit);
        return hit.isHit(0) ? hit.t[0] : -1;
    };
    for (const RayKind kind : {RayKind::Primary, RayKind::Mirror, RayKind::Refracted})
        EXPECT_FLOAT_EQ(met(kind), 4) << static_cast<int>(kind);
    for (const RayKind kind : {RayKind::Shadow, RayKind::Occlusion, RayKind::Scattered})
        EXPECT_FLOAT_EQ(met(kind), 2) << static_cast<int>(kind);
    HitWave seen;
    tracerOf(s)->intersectSeen(down, seen);
    EXPECT_FLOAT_EQ(seen.t[0], 4) << "what no surface has scattered";
    s.scene.sections.light = SectionLight::Cut;
    for (const RayKind kind : {RayKind::Primary, RayKind::Shadow, RayKind::Occlusion, RayKind::Scattered})
        EXPECT_FLOAT_EQ(met(kind), 4) << static_cast<int>(kind);
    std::vector<std::uint8_t> occluded;
    RayWave across;
    across.push({{-3, 0.5F, 0}, 0, {1, 0, 0}, 6});
    tracerOf(s)->occluded(RayKind::Shadow, across, occluded);
    EXPECT_EQ(occluded[0], 0);
}

TEST(Sections, OfPlanesBesideTheModelCostNothing) {
    test::SceneBuilder b = test::block();
    b.scene.sections.planes = {{{0, 1.5F, 0}, {0, 1, 0}}, {{-2, 0, 0}, {-1, 0, 0}}};
    const test::TracedScene s(b.finish());
    EXPECT_EQ(tracerOf(s).get(), static_cast<const RayTracer*>(&s.tracer));
}

/// A block above which a roof is left whole, and what a shadow ray meets of both where light is cut, too.
TEST(Sections, LeavePartsWhole) {
    test::SceneBuilder b = test::block();
    const auto first = static_cast<std::uint32_t>(b.buffers.triangles.size());
    b.square({0, 2, 0}, {0, 1, 0}, 1, b.material(test::matte(0.5F)));
    b.buffers.parts = {{b.buffers.addName("roof"), first, 2}};
    b.scene.sections = {{{{0, 0, 0}, {0, 1, 0}}}, SectionLight::Cut, {}};
    test::TracedScene s(b.finish());
    RayWave down;
    down.push({{0.2F, 3, 0.1F}, 0, {0, -1, 0}, kFar});
    down.push({{0.2F, 1.5F, 0.1F}, 0, {0, -1, 0}, 1});
    const auto check = [&](std::uint8_t roof) {
        const auto tracer = tracerOf(s);
        HitWave hits;
        tracer->intersect(RayKind::Primary, down, hits);
        EXPECT_FLOAT_EQ(hits.t[0], roof != 0 ? 1 : 4);
        std::vector<std::uint8_t> occluded;
        tracer->occluded(RayKind::Shadow, down, occluded);
        EXPECT_EQ(occluded, (std::vector<std::uint8_t>{1, 0}));
        std::vector<Obstacle> found;
        const std::vector<std::uint8_t> clear(s.scene.materials.size());
        RayWave up;
        up.push({{0.2F, 0.5F, 0.1F}, 0, {0, 1, 0}, kFar});
        tracer->findObstacles(up, clear, found);
        EXPECT_EQ(found[0], roof != 0 ? Obstacle::Opaque : Obstacle::None);
    };
    check(0);
    s.scene.uncutParts = std::make_shared<const std::vector<std::uint8_t>>(1, std::uint8_t{1});
    check(1);
}

/// Also of rays along a plane, in front of it and behind it, and of a wave that fills no vector.
TEST(Sections, ClipRaysOfAWaveAsSingleOnes) {
    test::Random random(8);
    for (const std::size_t count : {1U, 3U, 21U, 64U}) {
        SectionPlanes sections = randomPlanes(random, 3);
        sections.planes[0] = {{0, 0.5F, 0}, {0, 1, 0}};
        const SectionClip clip(sections, {{-2, -2, -2}, {2, 2, 2}});
        RayWave wave;
        for (std::size_t i = 0; i < count; ++i) {
            Vec3 direction = random.vector(1);
            if (i % 3 == 0) direction.y = i % 2 == 0 ? 0.0F : -0.0F;
            wave.push({random.vector(1), 0.1F, direction, i % 4 == 0 ? 1.0F : kFar});
        }
        std::vector<float> begins(count), ends(count);
        const RaySpan rays{{wave.ox.data(), wave.oy.data(), wave.oz.data()},
                           {wave.dx.data(), wave.dy.data(), wave.dz.data()},
                           wave.tMin.data(),
                           wave.tMax.data(),
                           count};
        const RaySpan clipped = clipRays(clip.halves(), rays, begins.data(), ends.data());
        for (std::size_t i = 0; i < count; ++i) {
            float tMin = wave.tMin[i], tMax = wave.tMax[i];
            clip.clip(wave.ray(i), tMin, tMax);
            EXPECT_EQ(clipped.tMin[i], tMin) << i;
            EXPECT_EQ(clipped.tMax[i], tMax) << i;
        }
    }
}

/// Counts the trees that are made of its surfaces.
class CountingTracer final : public RayTracer {
  public:
    explicit CountingTracer(const RayTracer& tracer) : tracer_(tracer) {}
    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override {
        tracer_.intersect(kind, rays, hits);
    }
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override {
        tracer_.occluded(kind, rays, occluded);
    }
    Box3 bounds() const override { return tracer_.bounds(); }
    std::shared_ptr<const RayTracer> without(std::span<const std::uint8_t> left) const override {
        ++made;
        return tracer_.without(left);
    }
    std::shared_ptr<const RayTracer> within(std::span<const HalfSpace> halves) const override {
        ++cut;
        return tracer_.within(halves);
    }
    mutable int made = 0, cut = 0;

  private:
    const RayTracer& tracer_;
};

TEST(Sections, KeepTheTreeOfUncutPartsWhileTheyAreTheSame) {
    test::Random random(3);
    SectionPlanes level;
    level.planes = {{{0, 0, 0}, {0, 1, 0}}};
    test::TracedScene s = soup(random, level, true);
    const auto surfaces = std::make_shared<const CountingTracer>(s.tracer);
    SectionSurfaces known;
    const auto kept = shownTracer(surfaces, s.scene, known);
    s.scene.sections.planes[0].point.y = 0.5F;
    s.scene.uncutParts = std::make_shared<const std::vector<std::uint8_t>>(*s.scene.uncutParts);
    shownTracer(surfaces, s.scene, known);
    EXPECT_EQ(surfaces->made, 1) << "a plane moves, the parts are the same";
    s.scene.uncutParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1});
    shownTracer(surfaces, s.scene, known);
    EXPECT_EQ(surfaces->made, 2) << "other parts";
    const auto others = std::make_shared<const CountingTracer>(s.tracer);
    shownTracer(others, s.scene, known);
    EXPECT_EQ(others->made, 1) << "other surfaces";
    s.scene.sections.planes.clear();
    EXPECT_EQ(shownTracer(others, s.scene, known), others);
    EXPECT_EQ(others.use_count(), 1) << "nothing is kept without a section";
}

TEST(Sections, KeepTheTracerOfWhatIsLeftWhilePlanesAreTheSame) {
    test::Random random(3);
    SectionPlanes level;
    level.planes = {{{0, 0, 0}, {0, 1, 0}}};
    test::TracedScene s = soup(random, level, false);
    const auto surfaces = std::make_shared<const CountingTracer>(s.tracer);
    SectionSurfaces known;
    shownTracer(surfaces, s.scene, known);
    s.scene.sections.light = SectionLight::Cut;
    shownTracer(surfaces, s.scene, known);
    EXPECT_EQ(surfaces->cut, 1) << "planes are the same";
    s.scene.sections.planes[0].point.y = 0.5F;
    shownTracer(surfaces, s.scene, known);
    EXPECT_EQ(surfaces->cut, 2) << "another plane";
    const auto others = std::make_shared<const CountingTracer>(s.tracer);
    shownTracer(others, s.scene, known);
    EXPECT_EQ(others->cut, 1) << "other surfaces";
}

/// Knows no tracer within half-spaces.
class UncuttableTracer final : public RayTracer {
  public:
    void intersect(RayKind /*kind*/, const RayWave& /*rays*/, HitWave& /*hits*/) const override {}
    void occluded(RayKind /*kind*/, const RayWave& /*rays*/,
                  std::vector<std::uint8_t>& /*occluded*/) const override {}
    Box3 bounds() const override { return {{-1, -1, -1}, {1, 1, 1}}; }
};

TEST(Sections, NeedSurfacesThatCanBeCut) {
    Scene scene;
    scene.sections.planes = {{{0, 0, 0}, {0, 1, 0}}};
    EXPECT_THROW(shownTracer(std::make_shared<const UncuttableTracer>(), scene), std::invalid_argument);
}

/// A face in a plane stays, whichever way rays come.
TEST(Sections, KeepFacesInAPlane) {
    test::SceneBuilder b = test::block();
    b.scene.sections.planes = {{{0, -1, 0}, {0, 1, 0}}};
    const test::TracedScene s(b.finish());
    RayWave rays;
    for (int i = 0; i < 100; ++i)
        rays.push({{0.019F * static_cast<float>(i) - 0.95F, 3, 0.3F}, 0, {0.01F, -1, 0.02F}, kFar});
    HitWave hits;
    tracerOf(s)->intersect(RayKind::Primary, rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_TRUE(hits.isHit(i)) << i;
}

/// The mean of paths that see a square of the floor, straight down from a height.
Colour floorFrom(const Scene& scene, float height, std::uint32_t samples) {
    const test::TracedScene s(scene);
    const auto tracer = tracerOf(s);
    Camera camera;
    camera.eye = {0, height, 0};
    camera.forward = {0, -1, 0};
    camera.up = {0, 0, -1};
    camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = 4;
    RenderSettings settings = test::exactSettings();
    settings.width = settings.height = 8;
    settings.path.emitters = EmitterLight::On;
    PathRenderer renderer;
    renderer.begin({s.scene, *tracer, camera, settings}, 1);
    RenderControl control{.threads = 1};
    EXPECT_TRUE(renderer.add({0, samples}, control));
    Frame frame;
    renderer.develop(frame);
    Colour sum;
    for (const Colour& each : frame.radiance.pixels) sum = sum + each;
    return sum / static_cast<float>(frame.radiance.pixels.size());
}

Scene cutRoom(SectionLight light, bool open = false) {
    test::SceneBuilder b = test::room(open);
    b.scene.lights = {test::pointLight({0, 1, 0}, 10)};
    b.scene.background = {1, 1, 1};
    b.scene.ambient = {1, 1, 1};
    if (!open) b.scene.sections = {{{{0, 1.999F, 0}, {0, 1, 0}}}, light, {}};
    return b.finish();
}

TEST(Sections, LetLightInAsIfTheModelWereCut) {
    const Colour cut = floorFrom(cutRoom(SectionLight::Cut), 5, 64);
    const Colour open = floorFrom(cutRoom(SectionLight::Cut, true), 5, 64);
    EXPECT_NEAR(cut.r, open.r, 0.01F * open.r);
    EXPECT_GT(cut.r, 1.2F * floorFrom(cutRoom(SectionLight::Whole), 5, 64).r);
}

TEST(Sections, LeaveRoomsTheirLight) {
    const Scene whole = cutRoom(SectionLight::Whole);
    Scene uncut = whole;
    uncut.sections = {};
    const Colour closed = floorFrom(uncut, 1.9F, 64);
    EXPECT_NEAR(floorFrom(whole, 5, 64).r, closed.r, 0.01F * closed.r);
}

/// A ceiling that shines, half of which is cut off, beside the half by itself.
TEST(Sections, LetWhatIsLeftOfEmittersShine) {
    const auto scene = [](float end, bool cut) {
        test::SceneBuilder b;
        b.square({0, -2, 0}, {0, 1, 0}, 6, b.material(test::matte(0.5F)));
        const std::uint32_t light = b.material(test::emitter({3, 3, 3}));
        b.quad({-2, 1, -1}, {end, 1, -1}, {end, 1, 1}, {-2, 1, 1}, light);
        b.quad({3, 1, -1}, {4, 1, -1}, {4, 1, 1}, {3, 1, 1}, light);
        if (cut) b.scene.sections = {{{{0.01F, 0, 0}, {1, 0, 0}}}, SectionLight::Cut, {}};
        return b.finish();
    };
    const auto below = [&](const Scene& s) { return floorFrom(s, 0.9F, 2000).r; };
    test::SceneBuilder half;
    half.quad({-6, -2, 6}, {0.01F, -2, 6}, {0.01F, -2, -6}, {-6, -2, -6}, half.material(test::matte(0.5F)));
    half.quad({-2, 1, -1}, {0.01F, 1, -1}, {0.01F, 1, 1}, {-2, 1, 1},
              half.material(test::emitter({3, 3, 3})));
    const float wanted = below(half.finish());
    EXPECT_GT(wanted, 0.05F);
    EXPECT_NEAR(below(scene(2, true)), wanted, 0.03F * wanted);
    EXPECT_GT(below(scene(2, false)), 1.5F * wanted);
}

/// A mirror shows the model cut open, too, by rays and by paths; what light meets there is whole.
TEST(Sections, AreSeenInMirrors) {
    test::SceneBuilder b;
    b.square({0, -2, 0}, {0, 1, 0}, 6, b.material(test::mirror(1)));
    b.square({0, 1, 0}, {0, -1, 0}, 20, b.material(test::emitter({1, 0, 0})));
    b.scene.background = {0, 1, 0};
    b.scene.sections.planes = {{{0, 0, 0}, {0, 1, 0}}};
    const Scene scene = b.finish();
    const Colour paths = floorFrom(scene, 5, 4);
    EXPECT_FLOAT_EQ(paths.r, 0);
    EXPECT_FLOAT_EQ(paths.g, 1);
    const test::TracedScene s(scene);
    const auto tracer = tracerOf(s);
    RayWave down;
    down.push({{0.3F, 5, 0.2F}, 0, {0, -1, 0}, kFar});
    const RenderSettings settings = test::exactSettings();
    WhittedIntegrator whitted(s.scene, *tracer, settings);
    whitted.trace(down, std::vector<SampleId>{{0, 0, 0}});
    EXPECT_FLOAT_EQ(whitted.radiance().colourAt(0).g, 1);
}

TEST(Sections, PlanesAroundABoxLeaveIt) {
    const std::vector<SectionPlane> planes = planesAround({-1, 2, 3}, {4, 5, 6});
    ASSERT_EQ(planes.size(), kMaxSectionPlanes);
    const auto removed = [&](Vec3 p) {
        return std::ranges::any_of(
            planes, [&](const SectionPlane& plane) { return dot(plane.normal, p - plane.point) > 0; });
    };
    EXPECT_FALSE(removed({0, 3, 4}));
    for (const Vec3 outside : {Vec3{-2, 3, 4}, {5, 3, 4}, {0, 1, 4}, {0, 6, 4}, {0, 3, 2}, {0, 3, 7}})
        EXPECT_TRUE(removed(outside));
}

} // namespace
