// A coat of varnish over a surface, under even light.
#include "rtcore/scattering/coat-inl.h"

#include "even_light.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

namespace formulas = rtcore::HWY_NAMESPACE;

/// A coat over lobes, as shading/surface/lobes-inl.h puts them together.
struct Varnished {
    formulas::CoatLobe<float> coat;
    formulas::MetallicLobes<float> below;

    Varnished(Vec3 base, float metallic, float weight, float roughness, float cosine)
        : coat(formulas::coatLobe<float>(ggxAlbedoTable(), weight, roughness, cosine)),
          below(formulas::metallicLobes<float>(ggxAlbedoTable(), base, metallic, 0.6F, {0.04F, 0.04F, 0.04F},
                                               cosine)) {
        formulas::layUnder<float>(1 - coat.albedo, below);
    }
    Vec3 albedoBelow() const { return below.diffuse + below.glossAlbedo + below.further; }
    float probability() const { return formulas::coatProbability<float>(coat.albedo, albedoBelow()); }

    formulas::Scattering<float> scatter(Vec3 viewer, Vec3 light) const {
        const auto base = formulas::scatterMetallic<float>(below, test::kTilted, viewer, light);
        const auto varnish = formulas::scatterCoat<float>(coat, test::kTilted, viewer, light);
        return {base.reflectance + varnish.reflectance,
                base.density + (varnish.density - base.density) * probability()};
    }
    Vec3 sample(Vec3 viewer, float lobe, test::Square p) const {
        if (lobe < probability()) return formulas::sampleGgx<float>(test::kTilted, viewer, coat.alpha, p);
        const float rest = (lobe - probability()) / (1 - probability());
        return formulas::sampleMetallic<float>(below, test::kTilted, viewer, std::min(rest, 0.9999999F), p);
    }
    Vec3d albedo(Vec3 viewer) const {
        return test::sampledAlbedo(
            16384, [&](float lobe, test::Square p) { return sample(viewer, lobe, p); },
            [&](Vec3 d) { return scatter(viewer, d); });
    }
};

TEST(Coat, OverWhiteSurfacesLosesNothing) {
    for (const float metallic : {0.0F, 1.0F}) {
        for (const float roughness : {0.05F, 0.3F, 0.8F}) {
            for (const float cosine : {1.0F, 0.5F, 0.1F}) {
                const Varnished surface({1, 1, 1}, metallic, 1, roughness, cosine);
                EXPECT_NEAR(surface.albedo(test::viewerAt(cosine)).x, 1, 0.012)
                    << metallic << ", " << roughness << ", " << cosine;
            }
        }
    }
}

/// By the closed form for a smooth coat: Schlick's curve of 0.04.
TEST(Coat, OverBlackGivesOffItsFresnelReflectance) {
    for (const float cosine : {1.0F, 0.5F, 0.2F}) {
        const Varnished surface({0, 0, 0}, 1, 0.5F, 0.05F, cosine);
        const double x = 1 - cosine;
        const double whole = 0.04 + 0.96 * x * x * x * x * x;
        EXPECT_NEAR(surface.coat.albedo, 0.5 * whole, 0.006) << cosine;
        const double base = (1 - surface.coat.albedo) *
                            (Varnished({0, 0, 0}, 1, 0, 0.05F, cosine).albedo(test::viewerAt(cosine)).x);
        EXPECT_NEAR(surface.albedo(test::viewerAt(cosine)).x, surface.coat.albedo + base, 0.004) << cosine;
    }
}

TEST(Coat, DirectionsFallByTheDensityOfAllLobes) {
    for (const float roughness : {0.45F, 1.0F}) {
        for (const float cosine : {0.9F, 0.2F}) {
            const Vec3 viewer = test::viewerAt(cosine);
            const Varnished surface({0.3F, 0.2F, 0.1F}, 0.3F, 0.9F, roughness, cosine);
            const double excess = test::excessOfSamples(
                [&](float lobe, test::Square p) { return surface.sample(viewer, lobe, p); },
                [&](Vec3 d) { return surface.scatter(viewer, d).density; });
            EXPECT_LT(excess, 5) << roughness << ", " << cosine;
        }
    }
}

TEST(Coat, OfNoWeightChangesNothing) {
    const Vec3 viewer = test::viewerAt(0.6F), light = test::viewerAt(0.8F);
    const Varnished without({0.7F, 0.4F, 0.2F}, 0.3F, 0, 0.2F, 0.6F);
    const auto lobes = formulas::metallicLobes<float>(ggxAlbedoTable(), {0.7F, 0.4F, 0.2F}, 0.3F, 0.6F,
                                                      {0.04F, 0.04F, 0.04F}, 0.6F);
    const auto plain = formulas::scatterMetallic<float>(lobes, test::kTilted, viewer, light);
    EXPECT_EQ(without.scatter(viewer, light).reflectance, plain.reflectance);
    EXPECT_EQ(without.scatter(viewer, light).density, plain.density);
}

} // namespace
} // namespace rtcore
