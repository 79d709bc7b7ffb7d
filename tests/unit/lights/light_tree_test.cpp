// A tree of lights holds each of them once, and chooses them with the probabilities that it tells.
#include "rtcore/lights/light_tree-inl.h"

#include "estimates.h"

#include "rtcore/lights/light_sample-inl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {
namespace light_tree_test {
namespace {

namespace plain = HWY_NAMESPACE;

const Box3 kLit{{-10, -10, -10}, {10, 10, 10}};

Vec3 randomPoint(test::Random& random) {
    return {random.number(-10, 10), random.number(-10, 10), random.number(-10, 10)};
}
Vec3 randomDirection(test::Random& random) {
    const Vec3 d = randomPoint(random);
    return length(d) > 0 ? normalize(d) : Vec3{0, 1, 0};
}

/// One of each kind in turn.
std::vector<Light> randomLights(std::size_t count, bool everyKind = true) {
    test::Random random(4);
    std::vector<Light> lights(count);
    const std::uint32_t web = keepPhotometry({{0, 15, 60}, {0, 180, 360}, {9, 8, 0, 9, 2, 0, 9, 8, 0}});
    for (std::size_t i = 0; i < count; ++i) {
        Light& light = lights[i];
        if (everyKind) light.kind = static_cast<LightKind>(i % kLightKinds);
        light.position = randomPoint(random);
        light.direction = randomDirection(random);
        light.right = normalize(basisAround(light.direction).tangent);
        const float intensity = random.number(0.1F, 5);
        light.intensity = {intensity, intensity, intensity};
        light.radius = light.kind == LightKind::Sphere ? random.number(0.1F, 1) : 0;
        light.width = random.number(0.1F, 2);
        light.height = random.number(0.1F, 2);
        light.cosOuter = random.number(0.1F, 0.8F);
        light.cosInner = random.number(0.81F, 0.99F);
        if (light.kind == LightKind::Ies) light.photometry = web;
    }
    return lights;
}

/// The leaf to which the trail of a light leads.
std::uint32_t leafOf(const LightTreeRows& rows, std::uint32_t light) {
    std::uint32_t node = rows.cut[rows.cutOf[light]], trail = rows.trail[light];
    while ((rows.nodes[node].kind & light_node::kLeaf) == 0) {
        node = (trail & 1U) == 0 ? node + 1 : rows.nodes[node].next;
        trail >>= 1U;
    }
    return node;
}

TEST(LightTree, HoldsEachLightOnceWhereItsTrailLeads) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{33}, std::size_t{700}}) {
        const std::vector<Light> lights = randomLights(count);
        LightTree tree;
        tree.prepare(lights, kLit);
        EXPECT_LE(tree.cut().size(), LightTree::kMaxCut);
        EXPECT_EQ(tree.cut().size(), std::min(count, LightTree::kMaxCut));
        std::vector<bool> seen(count);
        for (std::uint32_t k = 0; k < count; ++k) {
            const LightNode& leaf = tree.nodes()[leafOf(tree.rows(), k)];
            EXPECT_EQ(leaf.next, k);
            EXPECT_EQ((leaf.kind & light_node::kToHit) != 0, isAreaLight(lights[k].kind));
            seen[k] = true;
        }
        EXPECT_EQ(std::ranges::count(seen, true), static_cast<std::ptrdiff_t>(count));
        EXPECT_LE(tree.nodes().size(), 2 * count);
    }
}

TEST(LightTree, OfLightsAtOnePlaceOrInALineIsNotTooDeep) {
    std::vector<Light> lights(3000);
    for (const bool line : {false, true}) {
        for (std::size_t i = 0; i < lights.size(); ++i)
            lights[i].position.x = line ? std::exp2(static_cast<float>(i % 250) - 125) : 1;
        LightTree tree;
        tree.prepare(lights, kLit);
        for (std::uint32_t k = 0; k < lights.size(); ++k)
            ASSERT_EQ(tree.nodes()[leafOf(tree.rows(), k)].next, k) << line;
    }
}

TEST(LightTree, ProbabilitiesOfTheLightsOfANodeSumTo1) {
    const std::vector<Light> lights = randomLights(300);
    LightTree tree;
    tree.prepare(lights, kLit);
    const LightTreeRows rows = tree.rows();
    test::Random random(6);
    for (int i = 0; i < 50; ++i) {
        const Vec3 point = randomPoint(random), normal = randomDirection(random);
        std::vector<double> sums(rows.cuts);
        for (std::uint32_t k = 0; k < lights.size(); ++k) {
            const float p = plain::probabilityOfLeaf<float>(rows, k, point, normal);
            EXPECT_GT(p, 0);
            sums[rows.cutOf[k]] += static_cast<double>(p);
        }
        for (const double sum : sums) EXPECT_NEAR(sum, 1, 1e-5);
    }
}

TEST(LightTree, ExpectsLightFromANodeWhereverOneOfItsLightsThrowsSome) {
    const std::vector<Light> lights = randomLights(200);
    LightTree tree;
    tree.prepare(lights, kLit);
    const LightTreeRows rows = tree.rows();
    test::Random random(7);
    int lit = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 point = randomPoint(random), normal = randomDirection(random);
        for (std::uint32_t k = 0; k < lights.size(); ++k) {
            const float thrown = forKind(lights[k].kind, [&]<LightKind kind>() {
                const auto sample = plain::sampleLight<kind, float>(lights[k], point);
                return sample.irradiance.x * dot(normal, sample.toLight);
            });
            if (!(thrown > 1e-4F)) continue;
            ++lit;
            const LightNode& node = rows.nodes[rows.cut[rows.cutOf[k]]];
            EXPECT_GT(
                plain::expectedOfNode<float>(rows.directed, plain::broadcastNode<float>(node), point, normal),
                0);
        }
    }
    EXPECT_GT(lit, 5000);
}

TEST(LightTree, ChoosesLightsAsOftenAsItTells) {
    for (const bool everyKind : {false, true}) {
        const std::vector<Light> lights = randomLights(300, everyKind);
        LightTree tree;
        tree.prepare(lights, kLit);
        const LightTreeRows rows = tree.rows();
        EXPECT_EQ(rows.directed, everyKind);
        const Vec3 point{1, -2, 3}, normal = normalize({0.3F, 1, -0.2F});
        constexpr int kSamples = 1 << 14;
        for (std::uint32_t c = 0; c < rows.cuts; c += 5) {
            std::vector<int> chosen(lights.size());
            for (int i = 0; i < kSamples; i += static_cast<int>(plain::lanes())) {
                const plain::Float u =
                    (plain::toFloat(plain::toInt(plain::iota(static_cast<std::size_t>(i)))) + 0.5F) /
                    static_cast<float>(kSamples);
                const plain::ChosenLeaf leaf =
                    plain::chooseLeaf(rows, plain::Uint(rows.cut[c]), plain::allLanes(),
                                      plain::broadcast(point), plain::broadcast(normal), u);
                std::uint32_t light[plain::kLanes];
                float probability[plain::kLanes];
                plain::store(leaf.light, light);
                plain::store(leaf.probability, probability);
                for (std::size_t lane = 0; lane < plain::lanes(); ++lane) {
                    ++chosen[light[lane]];
                    EXPECT_EQ(probability[lane],
                              plain::probabilityOfLeaf<float>(rows, light[lane], point, normal))
                        << "to the bit";
                }
            }
            for (std::uint32_t k = 0; k < lights.size(); ++k) {
                if (rows.cutOf[k] != c) {
                    EXPECT_EQ(chosen[k], 0);
                    continue;
                }
                const float p = plain::probabilityOfLeaf<float>(rows, k, point, normal);
                EXPECT_NEAR(chosen[k], p * kSamples, 0.02F * p * kSamples + 3);
            }
        }
    }
}

TEST(LightTree, ShowsARayTheLightsThatItMeets) {
    const std::vector<Light> lights = randomLights(400);
    LightTree tree;
    tree.prepare(lights, kLit);
    test::Random random(9);
    std::size_t asked = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 point = randomPoint(random), direction = randomDirection(random);
        std::vector<bool> near(lights.size());
        plain::forLightsNear(tree.rows(), plain::broadcast(point), plain::broadcast(direction),
                             plain::allLanes(), [&](std::uint32_t k) {
                                 near[k] = true;
                                 ++asked;
                             });
        for (std::uint32_t k = 0; k < lights.size(); ++k) {
            if (lights[k].kind != LightKind::Sphere) continue;
            const Vec3 offset = lights[k].position - point;
            const float along = dot(offset, direction);
            const bool met =
                along > 0 && dot(offset, offset) - along * along < lights[k].radius * lights[k].radius;
            EXPECT_TRUE(!met || near[k]) << k;
        }
    }
    EXPECT_LT(asked, 300U * lights.size() / 10) << "not all of them";
}

} // namespace
} // namespace light_tree_test
} // namespace rtcore
