// Metals against random walks on the microsurface: how bright they are in light from discs in the sky, and in
// even light.
#include "rtcore/scattering/metallic-inl.h"

#include "even_light.h"
#include "microsurface_walk.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace rtcore {
namespace further_facets {
namespace {

namespace formulas = rtcore::HWY_NAMESPACE;
using Lobes = formulas::MetallicLobes<float>;

/// White, gold's blue, and a grey.
constexpr std::array kReflectances{1.0, 0.34, 0.5};
constexpr std::size_t kColours = kReflectances.size(), kDiscs = 4;
constexpr double kDiscRadius = 15; ///< degrees

/// The light that a metal sends to the viewer, by kReflectances.
struct Sent {
    std::array<std::array<double, kColours>, kDiscs> ofDisc{}; ///< pi f cos, its mean over the disc
    std::array<double, kColours> ofEven{};                     ///< of even light of radiance 1
};

Vec3d viewerOf(double cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

/// The middles of the discs: mirrored, half as far from the normal, aside, and on the viewer's side.
std::array<Vec3d, kDiscs> discs(Vec3d toViewer) {
    const auto at = [](double polar, double azimuth) {
        const double p = polar * std::numbers::pi / 180, a = azimuth * std::numbers::pi / 180;
        return Vec3d{std::sin(p) * std::cos(a), std::sin(p) * std::sin(a), std::cos(p)};
    };
    const double polar = std::acos(toViewer.z) * 180 / std::numbers::pi;
    return {at(polar, 180), at(polar > 10 ? polar / 2 : 30, 180), at(50, 90), at(40, 0)};
}

/// A direction in the disc, evenly by solid angle for u and v of 0..1.
Vec3d inDisc(Vec3d middle, double u, double v) {
    const double height = 1 - u * (1 - std::cos(kDiscRadius * std::numbers::pi / 180));
    const double ring = std::sqrt(1 - height * height), turn = 2 * std::numbers::pi * v;
    const Vec3d aside = normalize(cross(middle, std::fabs(middle.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0}));
    return middle * height + aside * (ring * std::cos(turn)) + cross(middle, aside) * (ring * std::sin(turn));
}

double schlick(double reflectance, double cosine) {
    return reflectance + (1 - reflectance) * std::pow(1 - cosine, 5);
}

Sent walked(double roughness, double cosine, int paths, test::Random& random) {
    const test::Microsurface surface(roughness);
    const Vec3d viewer = viewerOf(cosine);
    const auto middles = discs(viewer);
    Sent sum;
    for (int i = 0; i < paths; ++i) {
        std::array<double, kColours> weight;
        weight.fill(1);
        surface.walk(viewer, random, [&](Vec3d back, double below, double facetCosine) {
            for (std::size_t d = 0; d < kDiscs; ++d) {
                const double u = test::Microsurface::number(random), v = test::Microsurface::number(random);
                const Vec3d light = inDisc(middles[d], u, v);
                const double arriving =
                    surface.phase(back, light) * surface.free(light, below) * std::numbers::pi;
                if (!(arriving > 0)) continue;
                const double mirrored = std::sqrt((1 + dot(back, light)) / 2);
                for (std::size_t k = 0; k < kColours; ++k)
                    sum.ofDisc[d][k] += arriving * weight[k] * schlick(kReflectances[k], mirrored);
            }
            for (std::size_t k = 0; k < kColours; ++k) weight[k] *= schlick(kReflectances[k], facetCosine);
        });
        for (std::size_t k = 0; k < kColours; ++k) sum.ofEven[k] += weight[k];
    }
    for (auto& disc : sum.ofDisc)
        for (double& value : disc) value /= paths;
    for (double& value : sum.ofEven) value /= paths;
    return sum;
}

Sent modelled(double roughness, double cosine) {
    const Vec3d viewer = viewerOf(cosine);
    const auto single = [](Vec3d v) {
        return Vec3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    const Vec3 normal{0, 0, 1},
        base{1, static_cast<float>(kReflectances[1]), static_cast<float>(kReflectances[2])};
    const Lobes lobes =
        formulas::metallicLobes<float>(ggxAlbedoTable(), base, 1.0F, static_cast<float>(roughness),
                                       {0.04F, 0.04F, 0.04F}, static_cast<float>(cosine));
    Sent sent;
    const Vec3 all = lobes.glossAlbedo + lobes.further + lobes.diffuse;
    sent.ofEven = {static_cast<double>(all.x), static_cast<double>(all.y), static_cast<double>(all.z)};
    const auto middles = discs(viewer);
    constexpr int kRings = 200, kSectors = 64;
    for (std::size_t d = 0; d < kDiscs; ++d) {
        Vec3d sum;
        for (int i = 0; i < kRings * kSectors; ++i) {
            // Rings of the same width, since lobes are narrow.
            const double ring = (i / kSectors + 0.5) / kRings;
            const Vec3d light = inDisc(middles[d], ring * ring, (i % kSectors + 0.5) / kSectors);
            const auto s = formulas::scatterMetallic<float>(lobes, normal, single(viewer), single(light));
            const Vec3 f = s.reflectance * static_cast<float>(std::max(light.z, 0.0) * std::numbers::pi);
            sum += Vec3d{f.x, f.y, f.z} * (2 * ring);
        }
        sum = sum / static_cast<double>(kRings * kSectors);
        sent.ofDisc[d] = {sum.x, sum.y, sum.z};
    }
    return sent;
}

struct Case {
    double roughness, cosine;
    Sent sent;
};
/// By a million walks each, those between by 600,000.
const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {0.2,
         1,
         {{{{13.42, 4.563, 6.711},
            {0.1447, 0.04912, 0.07226},
            {0.01554, 0.005121, 0.007588},
            {0.03872, 0.01303, 0.01921}}},
          {1.0000, 0.3397, 0.4997}}},
        {0.2,
         0.7,
         {{{{13.77, 4.704, 6.901},
            {0.7694, 0.2617, 0.3847},
            {0.005212, 0.001594, 0.002407},
            {0.003529, 0.001039, 0.001585}}},
          {1.0000, 0.3416, 0.5010}}},
        {0.2,
         0.4,
         {{{{13.9, 5.447, 7.495},
            {0.1875, 0.06412, 0.09365},
            {0.004568, 0.001295, 0.001995},
            {0.003759, 0.00102, 0.001592}}},
          {1.0000, 0.3907, 0.5381}}},
        {0.2,
         0.15,
         {{{{13.57, 8.364, 9.622},
            {0.2299, 0.08225, 0.1163},
            {0.009524, 0.002759, 0.004223},
            {0.008602, 0.002452, 0.003773}}},
          {1.0000, 0.5982, 0.6948}}},
        {0.35,
         1,
         {{{{7.876, 2.676, 3.936},
            {0.7778, 0.2626, 0.3868},
            {0.1289, 0.04172, 0.06207},
            {0.2816, 0.09383, 0.1386}}},
          {1.0000, 0.3367, 0.4963}}},
        {0.35,
         0.7,
         {{{{8.993, 3.069, 4.503},
            {2.355, 0.7974, 1.173},
            {0.04931, 0.01451, 0.02211},
            {0.03506, 0.009744, 0.01508}}},
          {1.0000, 0.3382, 0.4969}}},
        {0.35,
         0.4,
         {{{{9.987, 3.906, 5.371},
            {1.196, 0.4027, 0.5905},
            {0.04588, 0.01239, 0.01933},
            {0.0381, 0.009841, 0.01555}}},
          {1.0000, 0.3768, 0.5248}}},
        {0.35,
         0.15,
         {{{{8.316, 4.806, 5.65},
            {1.41, 0.5106, 0.7211},
            {0.06873, 0.02009, 0.03066},
            {0.06196, 0.01774, 0.02725}}},
          {1.0000, 0.4896, 0.6098}}},
        {0.5,
         1,
         {{{{3.254, 1.092, 1.611},
            {1.112, 0.365, 0.5412},
            {0.3679, 0.1137, 0.171},
            {0.6253, 0.2001, 0.2984}}},
          {1.0000, 0.3231, 0.4808}}},
        {0.5,
         0.7,
         {{{{4.169, 1.397, 2.058},
            {2.246, 0.7411, 1.097},
            {0.1877, 0.05197, 0.08042},
            {0.1474, 0.0377, 0.05961}}},
          {1.0000, 0.3217, 0.4780}}},
        {0.5,
         0.4,
         {{{{5.098, 1.967, 2.713},
            {2.022, 0.6642, 0.9802},
            {0.1701, 0.04506, 0.07058},
            {0.1489, 0.03714, 0.05919}}},
          {1.0000, 0.3441, 0.4938}}},
        {0.5,
         0.15,
         {{{{3.564, 2, 2.377},
            {2.329, 0.8447, 1.195},
            {0.1899, 0.05573, 0.08494},
            {0.1748, 0.04979, 0.07656}}},
          {1.0000, 0.4065, 0.5443}}},
        {0.7,
         1,
         {{{{1.311, 0.3713, 0.5692},
            {0.9598, 0.2628, 0.4063},
            {0.5938, 0.1579, 0.2461},
            {0.7727, 0.2078, 0.3228}}},
          {1.0000, 0.2729, 0.4225}}},
        {0.7,
         0.7,
         {{{{1.521, 0.4615, 0.6956},
            {1.385, 0.3988, 0.6094},
            {0.4644, 0.1163, 0.1844},
            {0.4411, 0.1005, 0.1635}}},
          {1.0000, 0.2760, 0.4255}}},
        {0.7,
         0.4,
         {{{{1.603, 0.5999, 0.8335},
            {1.521, 0.4681, 0.7017},
            {0.42, 0.1086, 0.1709},
            {0.41, 0.09856, 0.1582}}},
          {1.0000, 0.2982, 0.4474}}},
        {0.7,
         0.15,
         {{{{1.074, 0.5946, 0.7092},
            {1.676, 0.5902, 0.8435},
            {0.3977, 0.1156, 0.1765},
            {0.3883, 0.1084, 0.1675}}},
          {1.0000, 0.3446, 0.4919}}},
        {1,
         1,
         {{{{1.124, 0.1489, 0.274},
            {0.9317, 0.1318, 0.2388},
            {0.6327, 0.1024, 0.1796},
            {0.7938, 0.119, 0.2125}}},
          {1.0000, 0.1616, 0.2828}}},
        {1,
         0.7,
         {{{{0.6966, 0.1246, 0.213},
            {0.9287, 0.1496, 0.2626},
            {0.6364, 0.1167, 0.1987},
            {0.7658, 0.132, 0.2281}}},
          {1.0000, 0.1856, 0.3141}}},
        {1,
         0.4,
         {{{{0.4333, 0.1169, 0.1758},
            {0.7622, 0.1583, 0.2609},
            {0.63, 0.1379, 0.225},
            {0.7161, 0.1503, 0.2479}}},
          {1.0000, 0.2261, 0.3643}}},
        {1,
         0.15,
         {{{{0.2668, 0.1269, 0.1563},
            {0.6306, 0.1788, 0.2698},
            {0.5964, 0.1615, 0.2505},
            {0.6327, 0.1678, 0.2618}}},
          {1.0000, 0.2869, 0.4341}}},
        // Between them.
        {0.28,
         0.25,
         {{{{12.11, 5.927, 7.419},
            {0.6097, 0.21, 0.3032},
            {0.02411, 0.006664, 0.01033},
            {0.02117, 0.005684, 0.00889}}},
          {1.0000, 0.4646, 0.5925}}},
        {0.42,
         0.83,
         {{{{5.882, 1.992, 2.931},
            {3.35, 1.132, 1.667},
            {0.1267, 0.03807, 0.05769},
            {0.08931, 0.02554, 0.03921}}},
          {1.0000, 0.3315, 0.4901}}},
        {0.6,
         0.55,
         {{{{2.751, 0.9301, 1.355},
            {1.813, 0.5707, 0.8537},
            {0.3008, 0.0782, 0.123},
            {0.2687, 0.06416, 0.1033}}},
          {1.0000, 0.3074, 0.4596}}},
        {0.85,
         0.9,
         {{{{1.013, 0.2179, 0.3563},
            {1.067, 0.222, 0.3661},
            {0.6178, 0.1333, 0.2185},
            {0.6995, 0.1391, 0.2329}}},
          {1.0000, 0.2206, 0.3591}}},
        {0.6,
         0.1,
         {{{{1.611, 0.9898, 1.14},
            {2.228, 0.832, 1.164},
            {0.2922, 0.08878, 0.1341},
            {0.2768, 0.08166, 0.1244}}},
          {1.0000, 0.3861, 0.5286}}},
        {0.28,
         0.9,
         {{{{11.13, 3.784, 5.564},
            {7.07, 2.403, 3.534},
            {0.03434, 0.01103, 0.01644},
            {0.02369, 0.007418, 0.01113}}},
          {1.0000, 0.3387, 0.4985}}},
    };
    return all;
}

TEST(FurtherFacets, WalksFindTheValuesThatAreHeldHere) {
    test::Random random(1);
    for (const Case& c : cases()) {
        const Sent found = walked(c.roughness, c.cosine, 4000, random);
        for (std::size_t k = 0; k < kColours; ++k)
            EXPECT_NEAR(found.ofEven[k], c.sent.ofEven[k], 0.02) << c.roughness << ", " << c.cosine;
        // The mirrored disc, into which most paths go.
        EXPECT_NEAR(found.ofDisc[0][0] / c.sent.ofDisc[0][0], 1, 0.15) << c.roughness << ", " << c.cosine;
    }
}

// To within parts of a disc's own light, and of the brightest disc's, by which faint ones are measured.
TEST(FurtherFacets, DiscsAreAsBrightAsByWalks) {
    for (const Case& c : cases()) {
        const Sent sent = modelled(c.roughness, c.cosine);
        for (std::size_t k = 0; k < kColours; ++k) {
            const double max = std::max(c.sent.ofDisc[0][k], c.sent.ofDisc[1][k]);
            for (std::size_t d = 0; d < kDiscs; ++d) {
                EXPECT_NEAR(sent.ofDisc[d][k], c.sent.ofDisc[d][k], 0.02 * c.sent.ofDisc[d][k] + 0.002 * max)
                    << c.roughness << ", " << c.cosine << ", disc " << d << ", colour " << k;
            }
        }
    }
}

TEST(FurtherFacets, AlbedosAreThoseOfWalks) {
    for (const Case& c : cases()) {
        const Sent sent = modelled(c.roughness, c.cosine);
        for (std::size_t k = 0; k < kColours; ++k) {
            EXPECT_NEAR(sent.ofEven[k] / c.sent.ofEven[k], 1, k == 0 ? 1e-4 : 0.005)
                << c.roughness << ", " << c.cosine << ", " << k;
        }
    }
}

// For any colour, roughness and viewer: and all that white metal lacks is put back.
TEST(FurtherFacets, NothingIsNegativeOrLost) {
    const auto expectAll = [](Vec3 v, float min, auto where) {
        EXPECT_GE(std::min({v.x, v.y, v.z}), min) << where[0] << ", " << where[1];
    };
    constexpr int kSteps = 40, kSide = 32;
    for (int i = 0; i <= kSteps; ++i) {
        const float roughness = static_cast<float>(i) / kSteps;
        for (int j = 0; j <= kSteps; ++j) {
            const float root = static_cast<float>(j) / kSteps, cosine = std::max(root * root, 1e-3F);
            const Lobes lobes = formulas::metallicLobes<float>(ggxAlbedoTable(), {1, 0.4F, 0.05F}, 1.0F,
                                                               roughness, {0.04F, 0.04F, 0.04F}, cosine);
            const std::array where{roughness, cosine};
            expectAll(lobes.straight, 0, where);
            expectAll(lobes.grazing, 0, where);
            expectAll(lobes.further, 0, where);
            EXPECT_NEAR(lobes.glossAlbedo.x + lobes.further.x, 1, 1e-5) << roughness << ", " << cosine;
            const double sine = std::sqrt(1 - double{cosine} * cosine);
            double sum = 0;
            for (int k = 0; k < kSide * kSide; ++k) {
                const double light = (k % kSide + 0.5) / kSide;
                const double turn = 2 * std::numbers::pi * (k / kSide + 0.5) / kSide;
                const double around = cosine * light + sine * std::sqrt(1 - light * light) * std::cos(turn);
                const float factor = formulas::furtherFactor<float>(
                    lobes.shape, cosine, static_cast<float>(light), static_cast<float>(around));
                EXPECT_GE(factor, 0) << roughness << ", " << cosine << ", " << light << ", " << turn;
                sum += 2 * light * static_cast<double>(factor);
            }
            EXPECT_NEAR(sum / (kSide * kSide), 1, 2e-3) << roughness << ", " << cosine;
        }
    }
}

// A floor of white metal under a rectangle: what a renderer finds that follows light from facet to facet.
TEST(FurtherFacets, FloorUnderARectangle) {
    struct Point {
        Vec3d position;
        double radiance;
    };
    const Vec3d eye{0, 1.2, 4}, middle{0, 2, -3}, axis = normalize(Vec3d{0, -0.3, 1});
    const Vec3d right{1, 0, 0}, up = cross(axis, right);
    constexpr double kWidth = 1.5, kHeight = 1, kIntensity = 20;
    const auto single = [](Vec3d v) { // its normal is z
        return Vec3{static_cast<float>(v.x), static_cast<float>(-v.z), static_cast<float>(v.y)};
    };
    for (const Point& p : {Point{{0, 0, 0}, 2.387}, {{0, 0, 1.5}, 1.689}, {{1.2, 0, 0}, 0.173}}) {
        const Vec3 viewer = single(normalize(eye - p.position));
        const Lobes lobes = formulas::metallicLobes<float>(ggxAlbedoTable(), {1, 1, 1}, 1.0F, 0.5F,
                                                           {0.04F, 0.04F, 0.04F}, viewer.z);
        double sum = 0;
        constexpr int kSide = 32;
        for (int i = 0; i < kSide * kSide; ++i) {
            const Vec3d at = middle + right * (kWidth * ((i % kSide + 0.5) / kSide - 0.5)) +
                             up * (kHeight * ((i / kSide + 0.5) / kSide - 0.5));
            const Vec3d offset = at - p.position, toLight = normalize(offset);
            const double cosine = -dot(toLight, axis);
            const auto s = formulas::scatterMetallic<float>(lobes, {0, 0, 1}, viewer, single(toLight));
            sum +=
                static_cast<double>(s.reflectance.x) * toLight.y * kIntensity * cosine / dot(offset, offset);
        }
        EXPECT_NEAR(sum / (kSide * kSide) / p.radiance, 1, 0.02) << p.position.x << ", " << p.position.z;
    }
}

} // namespace
} // namespace further_facets
} // namespace rtcore
