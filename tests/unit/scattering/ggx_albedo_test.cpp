#include "rtcore/scattering/ggx_albedo-inl.h"

#include "even_light.h"
#include "rtcore/scattering/ggx-inl.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

namespace formulas = rtcore::HWY_NAMESPACE;

// By quadrature in double, elsewhere.
TEST(GgxAlbedo, ItsTwoParts) {
    struct Row {
        float alpha, cosine;
        double straight, grazing;
    };
    constexpr Row kRows[] = {
        {0.04F, 1, 0.9980, 0}, {0.04F, 0.5F, 0.9631, 0.0323}, {0.04F, 0.1F, 0.4593, 0.4697},
        {0.25F, 1, 0.9158, 0}, {0.25F, 0.5F, 0.8349, 0.0223}, {0.25F, 0.1F, 0.7519, 0.1397},
        {1, 1, 0.3068, 0},     {1, 0.5F, 0.4477, 0.0030},     {1, 0.1F, 0.7363, 0.0239}};
    for (const Row& row : kRows) {
        const auto albedo = formulas::ggxAlbedo<float>(ggxAlbedoTable(), row.cosine, std::sqrt(row.alpha));
        EXPECT_NEAR(albedo.straight + albedo.grazing, row.straight + row.grazing, 0.005)
            << row.alpha << ", " << row.cosine;
        EXPECT_NEAR(albedo.grazing, row.grazing, 0.008) << row.alpha << ", " << row.cosine;
    }
}

TEST(GgxAlbedo, PerfectMirrorsWithTheFactorAreWhite) {
    constexpr int kSide = 24;
    double squares = 0;
    int count = 0;
    for (int row = 0; row <= kSide; ++row) {
        const float roughness = static_cast<float>(row) / kSide;
        const float alpha = formulas::ggxAlpha<float>(roughness);
        for (int column = 1; column <= kSide; ++column) {
            const float root = static_cast<float>(column) / kSide, cosine = root * root;
            const Vec3 viewer = test::viewerAt(cosine);
            const double truth = test::sampledAlbedo(
                                     2048,
                                     [&](float, test::Square p) {
                                         return formulas::sampleGgx<float>(test::kTilted, viewer, alpha, p);
                                     },
                                     [&](Vec3 d) {
                                         const auto s =
                                             formulas::scatterGgx<float>(test::kTilted, viewer, d, alpha);
                                         return test::Scattered{{s.lobe, s.lobe, s.lobe}, s.density};
                                     })
                                     .x;
            const auto albedo = formulas::ggxAlbedo<float>(ggxAlbedoTable(), cosine, roughness);
            const double furnace = truth / (albedo.straight + albedo.grazing);
            // At grazing angles polished metals change quickly.
            EXPECT_NEAR(furnace, 1, cosine < 0.02F ? 0.035 : 0.006) << roughness << ", " << cosine;
            if (cosine < 0.02F) continue;
            squares += (furnace - 1) * (furnace - 1);
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.0008);
}

TEST(GgxAlbedo, OutsideItsRangeTheNearestHolds) {
    const GgxAlbedoTable& table = ggxAlbedoTable();
    EXPECT_EQ(&table, &ggxAlbedoTable());
    const auto same = [&](float cosine, float roughness, float nearCosine, float nearRoughness) {
        const auto a = formulas::ggxAlbedo<float>(table, cosine, roughness);
        const auto b = formulas::ggxAlbedo<float>(table, nearCosine, nearRoughness);
        return a.straight == b.straight && a.grazing == b.grazing;
    };
    EXPECT_TRUE(same(2, 0.3F, 1, 0.3F));
    EXPECT_TRUE(same(-1, 0.3F, 0, 0.3F));
    EXPECT_TRUE(same(0.5F, 7, 0.5F, 1));
    EXPECT_TRUE(same(std::nanf(""), std::nanf(""), 0, 0));
    const auto last = formulas::ggxAlbedo<float>(table, 1, 1);
    EXPECT_EQ(last.straight, table.straight[kGgxAlbedoSide * kGgxAlbedoSide - 1]);
}

// By quadrature in double, elsewhere.
TEST(GgxAlbedo, MeanOverAllAngles) {
    struct Case {
        float roughness;
        double mean;
    };
    for (const Case& c :
         {Case{0.1F, 0.9997}, {0.2F, 0.9956}, {0.3F, 0.9771}, {0.5F, 0.8823}, {0.7F, 0.7074}, {1, 0.4092}}) {
        const auto albedo = formulas::ggxAlbedo<float>(ggxAlbedoTable(), 0.5F, c.roughness);
        EXPECT_NEAR(albedo.mean, c.mean, 0.002) << c.roughness;
    }
}

} // namespace
} // namespace rtcore
