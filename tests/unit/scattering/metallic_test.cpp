// Surfaces of the metallic-roughness model under even light.
#include "rtcore/scattering/metallic-inl.h"

#include "even_light.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

namespace formulas = rtcore::HWY_NAMESPACE;
using Lobes = formulas::MetallicLobes<float>;

Lobes lobesOf(Vec3 base, float metallic, float roughness, float cosine) {
    return formulas::metallicLobes<float>(ggxAlbedoTable(), base, metallic, roughness, {0.04F, 0.04F, 0.04F},
                                          cosine);
}

Vec3d albedoOf(const Lobes& lobes, Vec3 viewer, std::uint32_t count = 8192) {
    return test::sampledAlbedo(
        count,
        [&](float lobe, test::Square p) {
            return formulas::sampleMetallic<float>(lobes, test::kTilted, viewer, lobe, p);
        },
        [&](Vec3 d) { return formulas::scatterMetallic<float>(lobes, test::kTilted, viewer, d); });
}

Vec3d albedoAt(Vec3 base, float metallic, float roughness, float cosine, std::uint32_t count = 8192) {
    return albedoOf(lobesOf(base, metallic, roughness, cosine), test::viewerAt(cosine), count);
}

TEST(Metallic, WhiteSurfacesGiveOffWhatTheyGet) {
    for (const float metallic : {0.0F, 0.5F, 1.0F}) {
        for (const float roughness : {0.0F, 0.1F, 0.3F, 0.5F, 0.7F, 1.0F}) {
            for (const float cosine : {1.0F, 0.6F, 0.3F, 0.1F, 0.02F}) {
                const Vec3d albedo = albedoAt({1, 1, 1}, metallic, roughness, cosine);
                EXPECT_NEAR(albedo.x, 1, 0.009) << metallic << ", " << roughness << ", " << cosine;
                EXPECT_EQ(albedo.x, albedo.z);
            }
        }
    }
}

// By walks of 4 million paths (microsurface_walk.h).
TEST(Metallic, AlbedosOfMetals) {
    const Vec3d quarter = albedoAt({0.9F, 0.5F, 0.04F}, 1, 0.5F, 0.5F);
    EXPECT_NEAR(quarter.x, 0.8921, 0.002);
    EXPECT_NEAR(quarter.y, 0.4844, 0.002);
    EXPECT_NEAR(quarter.z, 0.0596, 0.001);
    const Vec3d rough = albedoAt({0.9F, 0.5F, 0.04F}, 1, 1, 0.5F, 131072);
    EXPECT_NEAR(rough.x, 0.8337, 0.003);
    EXPECT_NEAR(rough.y, 0.3449, 0.002);
}

TEST(Metallic, BlackDielectricsOnlyGloss) {
    const Vec3d gloss = albedoAt({0, 0, 0}, 0, 0.5F, 0.5F);
    EXPECT_NEAR(gloss.x, 0.0566, 0.001);
    const Lobes lobes = lobesOf({0, 0, 0}, 0, 0.5F, 0.5F);
    EXPECT_EQ(formulas::glossProbability<float>(lobes), 1);
    EXPECT_NEAR(lobes.glossAlbedo.x, gloss.x, 0.001);
}

TEST(Metallic, MixesResultsAndNotReflectances) {
    const Vec3 base{0.8F, 0.5F, 0.2F};
    for (const float roughness : {0.4F, 1.0F}) {
        const Vec3d metal = albedoAt(base, 1, roughness, 0.6F), other = albedoAt(base, 0, roughness, 0.6F);
        const Vec3d mixed = albedoAt(base, 0.25F, roughness, 0.6F);
        EXPECT_NEAR(mixed.x, 0.25 * metal.x + 0.75 * other.x, 2e-3);
        EXPECT_NEAR(mixed.z, 0.25 * metal.z + 0.75 * other.z, 2e-3);
    }
}

TEST(Metallic, DirectionsFallByTheDensityOfAllLobes) {
    for (const float metallic : {0.0F, 0.3F, 1.0F}) {
        for (const float roughness : {0.45F, 1.0F}) {
            for (const float cosine : {0.9F, 0.15F}) {
                const Vec3 viewer = test::viewerAt(cosine);
                const Lobes lobes = lobesOf({0.7F, 0.4F, 0.2F}, metallic, roughness, cosine);
                const double excess = test::excessOfSamples(
                    [&](float lobe, test::Square p) {
                        return formulas::sampleMetallic<float>(lobes, test::kTilted, viewer, lobe, p);
                    },
                    [&](Vec3 d) {
                        return formulas::scatterMetallic<float>(lobes, test::kTilted, viewer, d).density;
                    });
                EXPECT_LT(excess, 5) << metallic << ", " << roughness << ", " << cosine;
            }
        }
    }
}

// However a direction is sampled, its weight stays small.
TEST(Metallic, NoWeightIsLarge) {
    test::Random random(8);
    for (const float roughness : {0.1F, 0.2F, 0.35F, 0.5F, 0.7F, 1.0F}) {
        for (const float cosine : {1.0F, 0.7F, 0.3F, 0.1F, 0.02F}) {
            const Vec3 viewer = test::viewerAt(cosine);
            const Lobes lobes = lobesOf({1, 1, 1}, 1, roughness, cosine);
            for (int i = 0; i < 4000; ++i) {
                const float lobe = random.number(0, 0.9999999F), u = random.number(0, 0.9999999F);
                const Vec3 d = formulas::sampleMetallic<float>(lobes, test::kTilted, viewer, lobe,
                                                               {u, random.number(0, 0.9999999F)});
                const auto s = formulas::scatterMetallic<float>(lobes, test::kTilted, viewer, d);
                if (!(s.density > 0)) continue;
                ASSERT_GE(s.reflectance.x, 0);
                ASSERT_LT(s.reflectance.x * dot(d, test::kTilted) / s.density, 6)
                    << roughness << ", " << cosine;
            }
        }
    }
}

TEST(Metallic, QuadratureAndSamplingAgree) {
    const Vec3 viewer = test::viewerAt(0.4F);
    const Lobes lobes = lobesOf({0.7F, 0.4F, 0.2F}, 0.3F, 0.6F, 0.4F);
    const double albedo = test::overHemisphere(128, [&](Vec3 d) {
        const auto s = formulas::scatterMetallic<float>(lobes, test::kTilted, viewer, d);
        return s.reflectance.x * dot(d, test::kTilted);
    });
    EXPECT_NEAR(albedo, albedoOf(lobes, viewer).x, 1e-3);
    EXPECT_NEAR(albedo, lobes.diffuse.x + lobes.glossAlbedo.x + lobes.further.x, 5e-3);
}

TEST(Metallic, NothingGainsFromBelowItsSurface) {
    for (const float cosine : {-0.9F, -0.1F, 0.0F}) {
        const Vec3 viewer = formulas::liftedViewer<float>(test::viewerAt(cosine), test::kTilted);
        for (const float roughness : {0.0F, 0.2F, 1.0F}) {
            const Lobes lobes = lobesOf({1, 1, 1}, 0.5F, roughness, dot(viewer, test::kTilted));
            const double albedo = albedoOf(lobes, viewer, 2048).x;
            EXPECT_GT(albedo, 0.9) << cosine << ", " << roughness;
            EXPECT_LT(albedo, 1.02) << cosine << ", " << roughness;
        }
    }
}

} // namespace
} // namespace rtcore
