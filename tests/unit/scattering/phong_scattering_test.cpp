// The physical Phong model under even light.
#include "rtcore/scattering/phong_scattering-inl.h"

#include "even_light.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

namespace formulas = rtcore::HWY_NAMESPACE;
using PhongOfOne = formulas::PhongLobes<float>;

/// As MaterialTable has them.
PhongOfOne phongLobes(float kd, float ks, float shininess) {
    const float phong = std::min(shininess / kMinShininess, 1.0F), n = std::max(shininess, kMinShininess);
    const float diffuse = kd / kPi;
    return {
        {diffuse, diffuse, diffuse}, {ks, ks, ks}, n, phong * (n + 2) / (2 * kPi), (1 - phong) / (2 * kPi)};
}

double phongAlbedo(const PhongOfOne& lobes, float cosine, std::uint32_t count = 16384) {
    const Vec3 viewer = test::viewerAt(cosine);
    return test::sampledAlbedo(
               count,
               [&](float lobe, test::Square p) {
                   return formulas::samplePhongScattering<float>(lobes, test::kTilted, viewer, lobe, p);
               },
               [&](Vec3 d) { return formulas::scatterPhong<float>(lobes, test::kTilted, viewer, d); })
        .x;
}

constexpr float kPhongCosines[] = {1, 0.75F, 0.5F, 0.25F, 0.1F, 0};

// By quadrature in double, elsewhere; straight on it is 1, for exponent 1 at right angles 1 / pi.
TEST(PhongScattering, AlbedosOfTheLobe) {
    struct Row {
        float shininess;
        double albedos[6];
    };
    constexpr Row kRows[] = {{1, {1, 0.7880, 0.6090, 0.4533, 0.3699, 0.3183}},
                             {5, {1, 0.7519, 0.5194, 0.3209, 0.2240, 0.1698}},
                             {20, {1, 0.7500, 0.5005, 0.2635, 0.1468, 0.0881}},
                             {100, {1, 0.7500, 0.5000, 0.2502, 0.1082, 0.0398}}};
    for (const Row& row : kRows) {
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_NEAR(phongAlbedo(phongLobes(0, 1, row.shininess), kPhongCosines[i]), row.albedos[i], 1e-3)
                << row.shininess << ", " << kPhongCosines[i];
        }
    }
}

// 1 - c ln(1 + 1 / c), and what docs/shading.md has.
TEST(PhongScattering, AlbedosOfRoughMetals) {
    for (const float cosine : {1.0F, 0.5F, 0.17364818F}) {
        EXPECT_NEAR(phongAlbedo(phongLobes(0, 1, 0), cosine), 1 - cosine * std::log(1 + 1 / cosine), 1e-3);
    }
    EXPECT_NEAR(phongAlbedo(phongLobes(0, 1, 0.5F), 1), 0.653, 3e-3);
    EXPECT_NEAR(phongAlbedo(phongLobes(0, 1, 0.25F), 0.5F), 0.490, 3e-3);
}

TEST(PhongScattering, DiffuseAndGlossAddUp) {
    for (const float cosine : kPhongCosines) {
        const double gloss = phongAlbedo(phongLobes(0, 1, 20), cosine);
        EXPECT_NEAR(phongAlbedo(phongLobes(0.6F, 0.4F, 20), cosine), 0.6 + 0.4 * gloss, 2e-3) << cosine;
    }
    EXPECT_NEAR(phongAlbedo(phongLobes(0.6F, 0.4F, 100000), 1), 1, 2e-3);
    EXPECT_NEAR(phongAlbedo(phongLobes(0.6F, 0, 20), 0.3F), 0.6, 1e-5);
}

TEST(PhongScattering, DirectionsFallByTheDensityOfAllLobes) {
    for (const float shininess : {0.5F, 1.0F, 8.0F, 60.0F}) {
        for (const float cosine : {1.0F, 0.6F, 0.1F}) {
            const Vec3 viewer = test::viewerAt(cosine);
            for (const PhongOfOne& lobes : {phongLobes(0, 1, shininess), phongLobes(0.5F, 0.3F, shininess)}) {
                const double excess = test::excessOfSamples(
                    [&](float lobe, test::Square p) {
                        return formulas::samplePhongScattering<float>(lobes, test::kTilted, viewer, lobe, p);
                    },
                    [&](Vec3 d) {
                        return formulas::scatterPhong<float>(lobes, test::kTilted, viewer, d).density;
                    });
                EXPECT_LT(excess, 5) << shininess << ", " << cosine;
            }
        }
    }
}

TEST(PhongScattering, TheLobesDensityIsThatOfAllDirectionsAboutIt) {
    for (const float shininess : {1.0F, 7.0F, 200.0F}) {
        const double all = test::overHemisphere(256, [&](Vec3 d) {
            return formulas::phongDensityScale<float>(shininess) *
                   formulas::pow(dot(d, test::kTilted), shininess);
        });
        EXPECT_NEAR(all, 1, 1e-3) << shininess;
    }
}

TEST(PhongScattering, IsWhatTheLightsShow) {
    test::Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 viewer = random.unitVector(), light = random.unitVector();
        const float n = random.number(0, 50);
        const PhongOfOne lobes = phongLobes(0.3F, 0.5F, n);
        const auto s = formulas::scatterPhong<float>(lobes, test::kTilted, viewer, light);
        const float cosine = dot(light, test::kTilted);
        if (!(cosine > 0)) {
            ASSERT_EQ(s.reflectance.x, 0);
            ASSERT_EQ(s.density, 0);
            continue;
        }
        const float lobe = dot(test::kTilted * (2 * cosine) - light, viewer);
        float f = lobes.diffuseBrdf.x;
        if (lobe > 0) f += 0.5F * formulas::phongLobe<float>(lobe, lobes.shininess, lobes.lobeScale);
        f += 0.5F * formulas::roughLobe<float>(cosine, dot(viewer, test::kTilted), lobes.roughScale);
        ASSERT_EQ(s.reflectance.x, f);
        ASSERT_GT(s.density, 0);
    }
}

} // namespace
} // namespace rtcore
