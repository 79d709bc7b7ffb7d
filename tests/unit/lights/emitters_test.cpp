// Emissive triangles as lights: Lambert's formula for polygons, densities, and what is left out.
#include "rtcore/lights/emitters-inl.h"

#include "estimates.h"
#include "support/small_scene.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace rtcore {
namespace emitters_of_scenes {
namespace {

using SampledPoint = HWY_NAMESPACE::EmitterSample<float>;
using test::Estimate;
using test::expectMean;
using test::SceneBuilder;

/// Irradiance on a floor (y up) at the origin of a polygon of radiance 1 above it (Lambert 1760).
double lambert(const std::vector<Vec3d>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = normalize(corners[i]), b = normalize(corners[(i + 1) % corners.size()]);
        sum += std::acos(dot(a, b)) * normalize(cross(a, b)).y;
    }
    return std::fabs(sum) / 2;
}

Vec3d inDouble(Vec3 p) { return {p.x, p.y, p.z}; }

/// The distance at which a ray from the origin meets the triangle; 0: it does not.
double distanceTo(const Mesh& mesh, std::uint32_t triangle, Vec3d d) {
    const Vec3d a = inDouble(mesh.position(triangle, 0));
    const Vec3d ab = inDouble(mesh.position(triangle, 1)) - a, ac = inDouble(mesh.position(triangle, 2)) - a;
    const Vec3d p = cross(d, ac);
    const double det = dot(ab, p), u = -dot(a, p) / det;
    const Vec3d q = cross(a * -1.0, ab);
    const double v = dot(d, q) / det;
    const double t = dot(ac, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : 0;
}

/// The emitted light that one sampled point sends to the origin, times the cosine of a floor there.
double received(const Scene& scene, const SampledPoint& p) {
    const double square = dot(inDouble(p.position), inDouble(p.position));
    const Vec3d d = inDouble(p.position) / std::sqrt(square);
    const double cosines = std::max(d.y, 0.0) * std::fabs(dot(d, inDouble(p.normal)));
    const Material& m = scene.material(scene.mesh().shading[p.triangle].material);
    return static_cast<double>(m.emission.r) * cosines / (square * static_cast<double>(p.density));
}

/// A tilted quadrangle and a triangle, of other brightness, that do not hide each other.
Scene twoPolygons() {
    SceneBuilder b;
    const std::uint32_t dim = b.material(test::emitter(kWhite)),
                        bright = b.material(test::emitter(kWhite * 5.0F));
    b.triangle({5, 5, 5}, {6, 5, 5}, {5, 6, 5}, b.material(test::matte(1)));
    b.quad({-1, 1, -1}, {0.5F, 1.2F, -1}, {0.5F, 1.7F, 0.5F}, {-1, 1.5F, 0.5F}, dim);
    b.triangle({5, 5, 5}, {6, 5, 5}, {5, 6, 5}, b.material(test::matte(1)));
    b.triangle({1, 2, 0}, {2, 2, 0}, {2, 2.5F, 1}, bright);
    return b.finish();
}
double expectedOfTwoPolygons(const Mesh& mesh) {
    const auto corner = [&](std::uint32_t t, int i) { return inDouble(mesh.position(t, i)); };
    return lambert({corner(1, 0), corner(1, 1), corner(1, 2)}) +
           lambert({corner(2, 0), corner(2, 1), corner(2, 2)}) +
           5 * lambert({corner(4, 0), corner(4, 1), corner(4, 2)});
}

SampledPoint sampleOne(const Emitters& emitters, test::Random& random, std::uint32_t cluster = 0) {
    const float u = random.number(0, 1), v = random.number(0, 1);
    const std::uint32_t bits = random.index(std::size_t{1} << 32U);
    return HWY_NAMESPACE::sampleEmitter<float>(emitters.rows(), u, v, bits, cluster);
}

TEST(Emitters, GiveTheIrradianceOfLambertsFormula) {
    const Scene scene = twoPolygons();
    Emitters emitters;
    emitters.prepare(scene);
    ASSERT_EQ(emitters.size(), 3U);
    const double expected = expectedOfTwoPolygons(scene.mesh());
    test::Random random(1);
    Estimate bySamples, byHits, byBoth;
    for (int i = 0; i < 100000; ++i) {
        const SampledPoint p = sampleOne(emitters, random);
        const double one = received(scene, p);
        bySamples.add(one);
        const double distance = std::sqrt(dot(inDouble(p.position), inDouble(p.position)));
        const auto cosineOf = [&](std::uint32_t t, Vec3d d) {
            return dot(d, normalize(inDouble(scene.mesh().geometricNormal(t))));
        };
        // One sample of each, by the balance heuristic.
        const Vec3d toPoint = inDouble(p.position) / distance;
        const double density = static_cast<double>(emitters.density(
            p.triangle, static_cast<float>(distance), static_cast<float>(cosineOf(p.triangle, toPoint))));
        double both = one * density / (density + std::max(toPoint.y, 0.0) / test::kPi), hits = 0;
        const Vec3d d = inDouble(test::cosineDirection(random));
        for (std::uint32_t t = 0; t < scene.mesh().triangles.size(); ++t) {
            const double at = distanceTo(scene.mesh(), t, d);
            const auto emission =
                static_cast<double>(scene.material(scene.mesh().shading[t].material).emission.r);
            if (at == 0 || emission == 0) continue;
            const auto other = static_cast<double>(
                emitters.density(t, static_cast<float>(at), static_cast<float>(cosineOf(t, d))));
            hits += emission * test::kPi;
            both += emission * test::kPi * (d.y / test::kPi) / (other + d.y / test::kPi);
        }
        byHits.add(hits);
        byBoth.add(both);
    }
    expectMean(bySamples, expected);
    expectMean(byHits, expected);
    expectMean(byBoth, expected);
}

TEST(Emitters, HaveADensityThatIntegratesToOne) {
    const Scene scene = twoPolygons();
    Emitters emitters;
    emitters.prepare(scene);
    test::Random random(2);
    Estimate integral;
    for (int i = 0; i < 200000; ++i) {
        const Vec3 d = test::uniformDirection(random);
        double sum = 0;
        for (std::uint32_t t = 0; t < scene.mesh().triangles.size(); ++t) {
            const double at = distanceTo(scene.mesh(), t, inDouble(d));
            const float cosine = dot(d, normalize(scene.mesh().geometricNormal(t)));
            if (at > 0) sum += static_cast<double>(emitters.density(t, static_cast<float>(at), cosine));
        }
        integral.add(sum * 4 * test::kPi);
    }
    expectMean(integral, 1);
}

TEST(Emitters, HaveOneDensityForPointsAndForHits) {
    const Scene scene = twoPolygons();
    Emitters emitters;
    emitters.prepare(scene);
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const SampledPoint p = sampleOne(emitters, random);
        EXPECT_EQ(p.density, emitters.areaDensity(p.triangle));
        EXPECT_EQ(emitters.density(p.triangle, 3, -0.5F), emitters.density(p.triangle, 3, 0.5F));
        EXPECT_FLOAT_EQ(emitters.density(p.triangle, 3, 0.5F), p.density * 18);
    }
    for (const std::uint32_t none : {0U, 3U, 5U, 4000000000U}) EXPECT_EQ(emitters.areaDensity(none), 0);
    EXPECT_EQ(emitters.density(1, 3, 1e-7F), 0);
    EXPECT_GT(emitters.density(1, 3, 1e-5F), 0);
}

TEST(Emitters, AreSampledByPowerAndUniformlyOverATriangle) {
    SceneBuilder b;
    // Powers as 2 : 1 : 3, the last by the mean of its texture.
    b.triangle({0, 0, 0}, {2, 0, 0}, {0, 0, 2}, b.material(test::emitter({1, 1, 1})));
    b.triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, b.material(test::emitter({2, 2, 2})));
    Material textured = test::emitter({6, 6, 6});
    textured.emissionTexture = b.texture(2, 1, {{255, 255, 255, 255}, {0, 0, 0, 255}});
    b.triangle({0, 2, 0}, {1, 2, 0}, {0, 2, 2}, b.material(textured));
    const Scene scene = b.finish();
    Emitters emitters;
    emitters.prepare(scene);
    EXPECT_NEAR(emitters.power(), 2 * test::kPi * (2 + 1 + 3), 1e-5);
    EXPECT_EQ(emitters.bounds(), (Box3{{0, 0, 0}, {2, 2, 2}}));
    EXPECT_NEAR(emitters.centre().y, (0 * 2 + 1 * 1 + 2 * 3) / 6.0, 1e-6);

    test::Random random(4);
    constexpr int kCount = 100000;
    std::array<int, 3> counts{};
    Estimate u, v, product;
    for (int i = 0; i < kCount; ++i) {
        const SampledPoint p = sampleOne(emitters, random);
        ++counts[p.triangle];
        ASSERT_TRUE(p.u >= 0 && p.v >= 0 && p.u + p.v <= 1);
        u.add(static_cast<double>(p.u));
        v.add(static_cast<double>(p.v));
        product.add(static_cast<double>(p.u * p.v));
        const Mesh& mesh = scene.mesh();
        const Vec3 expected = mesh.position(p.triangle, 0) * (1 - p.u - p.v) +
                              mesh.position(p.triangle, 1) * p.u + mesh.position(p.triangle, 2) * p.v;
        ASSERT_LT(length(p.position - expected), 1e-6F);
        ASSERT_NEAR(std::fabs(p.normal.y), 1, 1e-6);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double p = std::array{2 / 6.0, 1 / 6.0, 3 / 6.0}[i];
        EXPECT_NEAR(counts[i] / double{kCount}, p, 5 * std::sqrt(p * (1 - p) / kCount));
    }
    expectMean(u, 1 / 3.0);
    expectMean(v, 1 / 3.0);
    expectMean(product, 1 / 12.0);

    EmitterChoice untextured;
    untextured.textures = false;
    emitters.prepare(scene, untextured);
    EXPECT_NEAR(emitters.power(), 2 * test::kPi * (2 + 1 + 6), 1e-5);
}

/// So many triangles of random places, sizes and brightness, every third of which emits nothing.
Scene manyTriangles(std::size_t count) {
    SceneBuilder b;
    const std::uint32_t black = b.material(test::matte(1)), dim = b.material(test::emitter(kWhite)),
                        bright = b.material(test::emitter(kWhite * 7));
    test::Random random(8);
    const auto vector = [&](float size) {
        return Vec3{random.number(-size, size), random.number(-size, size), random.number(-size, size)};
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 at = i % 7 == 0 ? Vec3{1, 2, 3} : vector(10);
        b.triangle(at + vector(0.3F), at + vector(0.3F), at + vector(0.3F),
                   i % 3 == 0   ? black
                   : i % 3 == 1 ? dim
                                : bright);
    }
    return b.finish();
}

TEST(Emitters, AreEachInOneClusterOfMany) {
    // Without a tree, one to a cluster, and several.
    for (const std::size_t count :
         {std::size_t{48}, std::size_t{50}, std::size_t{6000}, std::size_t{20000}}) {
        const Scene scene = manyTriangles(count);
        Emitters emitters;
        emitters.prepare(scene);
        const EmitterRows rows = emitters.rows();
        EXPECT_EQ(rows.byTree(), emitters.size() > Emitters::kMaxWithoutTree) << count;
        std::map<std::uint32_t, double> sums;
        for (std::uint32_t t = 0; t < count; ++t) {
            const auto density = static_cast<double>(emitters.areaDensity(t));
            EXPECT_EQ(density > 0, t % 3 != 0) << t;
            if (density == 0) continue;
            const double area = 0.5 * static_cast<double>(length(scene.mesh().geometricNormal(t)));
            sums[emitters.clusterOf(t)] += density * area;
        }
        EXPECT_EQ(sums.size(), rows.byTree() ? std::min(emitters.size(), EmitterClusters::kMaxClusters) : 1);
        for (const auto& [cluster, sum] : sums) ASSERT_NEAR(sum, 1, 1e-5) << cluster;
    }
}

TEST(Emitters, OfAClusterAreSampledAsOftenAsTold) {
    const Scene scene = manyTriangles(20000);
    Emitters emitters;
    emitters.prepare(scene);
    test::Random random(9);
    constexpr int kCount = 20000;
    for (const std::uint32_t cluster : {0U, 77U, 4095U}) {
        std::map<std::uint32_t, int> counts;
        for (int i = 0; i < kCount; ++i) {
            const SampledPoint p = sampleOne(emitters, random, cluster);
            ASSERT_EQ(emitters.clusterOf(p.triangle), cluster);
            ASSERT_EQ(p.density, emitters.areaDensity(p.triangle));
            ++counts[p.triangle];
        }
        for (const auto& [triangle, found] : counts) {
            const double p = static_cast<double>(emitters.areaDensity(triangle)) * 0.5 *
                             static_cast<double>(length(scene.mesh().geometricNormal(triangle)));
            EXPECT_NEAR(found / double{kCount}, p, 5 * std::sqrt(p / kCount)) << triangle;
        }
    }
}

TEST(Emitters, LeaveOutWhatHasNoAreaAndWhatIsNotANumber) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                    kInf = std::numeric_limits<float>::infinity();
    SceneBuilder b;
    const std::uint32_t ordinary = b.material(test::emitter(kWhite)),
                        huge = b.material(test::emitter(kWhite * 1e30F));
    b.triangle({0, 1, 0}, {1, 1, 1}, {2, 1, 2}, huge); // in a line
    b.triangle({0, 1, 0}, {0, 1, 0}, {0, 1, 0}, huge);
    b.triangle({0, 1, 0}, {1e-20F, 1, 0}, {0, 1, 1e-20F}, huge);
    b.triangle({0, kNan, 0}, {1, 1, 0}, {0, 1, 1}, huge);
    b.triangle({0, kInf, 0}, {1, 1, 0}, {0, 1, 1}, huge);
    b.triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, b.material(test::emitter({kNan, 1, 1})));
    b.triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, b.material(test::emitter({kInf, 1, 1})));
    b.triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, ordinary);
    const Scene scene = b.finish();
    Emitters emitters;
    emitters.prepare(scene);
    ASSERT_EQ(emitters.size(), 1U);
    EXPECT_FLOAT_EQ(emitters.areaDensity(7), 2);
    for (std::uint32_t i = 0; i < 7; ++i) EXPECT_EQ(emitters.areaDensity(i), 0) << i;
    test::Random random(5);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(sampleOne(emitters, random).triangle, 7U);
}

TEST(Emitters, OfHugeEmissionAreSampledBesideOthers) {
    SceneBuilder b;
    b.triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, b.material(test::emitter(kWhite * 1e30F)));
    b.triangle({0, 2, 0}, {1, 2, 0}, {0, 2, 1}, b.material(test::emitter(kWhite)));
    const Scene scene = b.finish();
    Emitters emitters;
    emitters.prepare(scene);
    ASSERT_EQ(emitters.size(), 2U);
    EXPECT_FLOAT_EQ(emitters.areaDensity(0), 2);
    EXPECT_GT(emitters.areaDensity(1), 0) << "no direction from which light comes has the density 0";
    EXPECT_TRUE(isFinite(emitters.centre()));
}

TEST(Emitters, LeaveOutHiddenTrianglesAndDarkMaterials) {
    const Scene scene = twoPolygons();
    Emitters emitters;
    const std::vector<std::uint8_t> hidden{0, 1, 0, 0, 0};
    emitters.prepare(scene, {hidden, {}, true});
    EXPECT_EQ(emitters.size(), 2U);
    EXPECT_EQ(emitters.areaDensity(1), 0);
    EXPECT_GT(emitters.areaDensity(2), 0);
    const std::vector<std::uint8_t> bright{0, 1, 0, 0};
    emitters.prepare(scene, {hidden, bright, true});
    EXPECT_EQ(emitters.size(), 1U);
    const std::vector<std::uint8_t> all{1, 1, 1, 1};
    emitters.prepare(scene, {{}, all, true});
    EXPECT_TRUE(emitters.empty());
    EXPECT_EQ(emitters.power(), 0);
    EXPECT_TRUE(emitters.bounds().empty());
    EXPECT_EQ(emitters.areaDensity(2), 0);
}

} // namespace
} // namespace emitters_of_scenes
} // namespace rtcore
