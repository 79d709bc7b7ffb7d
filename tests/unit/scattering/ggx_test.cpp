// The formulas of ggx-inl.h, for facets that are perfect mirrors.
#include "rtcore/scattering/ggx-inl.h"

#include "even_light.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

namespace formulas = rtcore::HWY_NAMESPACE;

test::Scattered mirrored(Vec3 toViewer, Vec3 toLight, float alpha) {
    const auto s = formulas::scatterGgx<float>(test::kTilted, toViewer, toLight, alpha);
    return {{s.lobe, s.lobe, s.lobe}, s.density};
}

double ggxAlbedoBySampling(float cosine, float roughness, std::uint32_t count) {
    const Vec3 viewer = test::viewerAt(cosine);
    const float alpha = formulas::ggxAlpha<float>(roughness);
    return test::sampledAlbedo(
               count,
               [&](float, test::Square p) {
                   return formulas::sampleGgx<float>(test::kTilted, viewer, alpha, p);
               },
               [&](Vec3 d) { return mirrored(viewer, d, alpha); })
        .x;
}

constexpr float kCosines[] = {1, 0.75F, 0.5F, 0.25F, 0.1F};

// By quadrature in double, elsewhere (two programs that agree to 2e-4).
TEST(Ggx, AlbedosOfPerfectMirrors) {
    struct Row {
        float roughness;
        double albedos[5], mean;
    };
    constexpr Row kRows[] = {{0.1F, {1.0000, 1.0000, 0.9999, 0.9991, 0.9942}, 0.9997},
                             {0.2F, {0.9980, 0.9975, 0.9953, 0.9835, 0.9289}, 0.9956},
                             {0.3F, {0.9909, 0.9867, 0.9752, 0.9318, 0.8843}, 0.9771},
                             {0.5F, {0.9158, 0.8915, 0.8573, 0.8401, 0.8916}, 0.8823},
                             {0.7F, {0.6978, 0.6902, 0.7040, 0.7685, 0.8619}, 0.7074},
                             {1.0F, {0.3069, 0.3645, 0.4507, 0.5976, 0.7602}, 0.4092}};
    for (const Row& row : kRows) {
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_NEAR(ggxAlbedoBySampling(kCosines[i], row.roughness, 16384), row.albedos[i], 6e-4)
                << row.roughness << ", " << kCosines[i];
        }
        double mean = 0; // of 2 c dc
        constexpr int kSteps = 32;
        for (int i = 0; i < kSteps; ++i) {
            const double c = std::sqrt((i + 0.5) / kSteps);
            mean += ggxAlbedoBySampling(static_cast<float>(c), row.roughness, 1024) / kSteps;
        }
        EXPECT_NEAR(mean, row.mean, 1.5e-3) << row.roughness;
    }
}

TEST(Ggx, SamplingAndQuadratureAgree) {
    for (const float roughness : {0.5F, 0.7F, 1.0F}) {
        for (const float cosine : kCosines) {
            const Vec3 viewer = test::viewerAt(cosine);
            const float alpha = roughness * roughness;
            const double albedo = test::overHemisphere(128, [&](Vec3 d) {
                return mirrored(viewer, d, alpha).reflectance.x * dot(d, test::kTilted);
            });
            EXPECT_NEAR(albedo, ggxAlbedoBySampling(cosine, roughness, 16384), 1e-3)
                << roughness << ", " << cosine;
        }
    }
}

TEST(Ggx, DirectionsFallByTheirDensity) {
    for (const float alpha : {0.1F, 0.25F, 1.0F}) {
        for (const float cosine : {1.0F, 0.7F, 0.2F}) {
            const Vec3 viewer = test::viewerAt(cosine);
            const double excess = test::excessOfSamples(
                [&](float, test::Square p) {
                    return formulas::sampleGgx<float>(test::kTilted, viewer, alpha, p);
                },
                [&](Vec3 d) { return mirrored(viewer, d, alpha).density; });
            EXPECT_LT(excess, 5) << alpha << ", " << cosine;
        }
    }
}

TEST(Ggx, TheDensityIsNeverThatOfMoreThanAll) {
    for (const float alpha : {0.1F, 0.25F, 0.5F, 1.0F}) {
        for (const float cosine : kCosines) {
            const Vec3 viewer = test::viewerAt(cosine);
            const double all =
                test::overHemisphere(128, [&](Vec3 d) { return mirrored(viewer, d, alpha).density; });
            EXPECT_LT(all, 1.001) << alpha << ", " << cosine;
            EXPECT_GT(all, 0.499) << alpha << ", " << cosine; // alpha 1 seen straight on: 1/2
        }
    }
}

TEST(Ggx, NarrowLobesKeepTheirForm) {
    // Seen straight on, alpha^2 / (alpha^2 + tan^2) of the facets is even. Chi-square of 32 parts.
    const float alpha = kMinAlpha;
    std::vector<double> found(32, 0), expected(32, 4096 / 32.0);
    test::Random random(4);
    for (int i = 0; i < 4096; ++i) {
        const Vec3 h =
            formulas::sampleFacet<float>(test::kTilted, test::kTilted, alpha,
                                         {random.number(0, 0.9999999F), random.number(0, 0.9999999F)});
        const Vec3 across = cross(test::kTilted, h);
        const double sine2 = dot(across, across), tangent2 = sine2 / (1 - sine2);
        const double even = 1.0 * alpha * alpha / (alpha * alpha + tangent2);
        found[static_cast<std::size_t>(std::min(even * 32, 31.0))] += 1;
    }
    EXPECT_LT(test::chiSquareExcess(found, expected), 5);
    // The distribution, integrated over facets of the angles that matter: with t = tan^2 / alpha^2 it is
    // 1 / (1 + t)^2 dt.
    const Basis basis = basisAround(test::kTilted);
    for (const double t : {0.0, 0.1, 1.0, 10.0}) {
        const double tangent = std::sqrt(t) * alpha, cosine = 1 / std::sqrt(1 + tangent * tangent);
        const Vec3 h = test::kTilted * static_cast<float>(cosine) +
                       basis.tangent * static_cast<float>(tangent * cosine * 0.6) +
                       basis.bitangent * static_cast<float>(tangent * cosine * 0.8);
        const double exact = 1 / (kPi * alpha * alpha * std::pow(cosine, 4) * (1 + t) * (1 + t));
        EXPECT_NEAR(formulas::ggxDistribution<float>(test::kTilted, h, alpha) / exact, 1, 2e-3) << t;
    }
}

TEST(Ggx, WithoutFacetsBelowTheSurfaceNothingIsLost) {
    EXPECT_NEAR(ggxAlbedoBySampling(0.5F, 0, 4096), 1, 1e-4);
    EXPECT_NEAR(ggxAlbedoBySampling(1, 0, 4096), 1, 1e-4);
}

TEST(Ggx, LightAndViewerMayBeExchanged) {
    test::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = test::viewerAt(random.number(0.01F, 1)), b = random.unitVector();
        if (dot(b, test::kTilted) < kMinViewerCosine) continue;
        const float alpha = random.number(0.01F, 1);
        const float there = mirrored(a, b, alpha).reflectance.x, back = mirrored(b, a, alpha).reflectance.x;
        ASSERT_NEAR(there, back, 1e-4F * there);
    }
}

TEST(Ggx, ViewersBelowTheSurfaceAreLifted) {
    for (const float cosine : {-1.0F, -0.5F, 0.0F, 5e-4F}) {
        const Vec3 lifted = formulas::liftedViewer<float>(test::viewerAt(cosine), test::kTilted);
        EXPECT_NEAR(length(lifted), 1, 1e-5);
        EXPECT_GT(dot(lifted, test::kTilted), 0.99F * kMinViewerCosine) << cosine;
        for (const float alpha : {kMinAlpha, 0.1F, 1.0F}) {
            for (const float u : {0.0F, 0.25F, 0.5F, 0.75F}) {
                const Vec3 d = formulas::sampleGgx<float>(test::kTilted, lifted, alpha, {u, 0.625F});
                EXPECT_NEAR(length(d), 1, 1e-4);
                const test::Scattered s = mirrored(lifted, d, alpha);
                EXPECT_TRUE(std::isfinite(s.reflectance.x) && std::isfinite(s.density));
                EXPECT_EQ(s.density > 0, dot(d, test::kTilted) > 0);
            }
        }
    }
    const Vec3 above = test::viewerAt(0.3F);
    EXPECT_EQ(formulas::liftedViewer<float>(above, test::kTilted), above);
    const test::Scattered below = mirrored(above, -above, 0.5F);
    EXPECT_EQ(below.reflectance.x, 0);
    EXPECT_EQ(below.density, 0);
}

} // namespace
} // namespace rtcore
