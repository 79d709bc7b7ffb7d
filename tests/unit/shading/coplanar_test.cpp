// Surfaces in one plane, lit: the first one is seen, as if it were alone.
#include "support/random_numbers.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

namespace rtcore {
namespace {

using test::SceneBuilder;
using test::TracedScene;

/// A wide floor and a small rug in its plane, tilted together; the rug has the lower numbers.
void addFloor(SceneBuilder& b, Vec3 normal, const Material& rug, bool floor, bool twice = false) {
    const std::uint32_t ofRug = b.material(rug), ofFloor = b.material(test::matte(0.1F));
    b.square({0, 0, 0}, normal, 0.5F, ofRug);
    if (twice) b.square({0, 0, 0}, -normal, 0.5F, ofRug);
    if (floor) b.square(cross(normal, {3, 1, 2}), normal, 400, ofFloor);
}

template <typename Use>
void forEachView(Vec3 normal, Use&& use) {
    const auto [tangent, bitangent] = basisAround(normal);
    test::Random random(8);
    for (int i = 0; i < 400; ++i) {
        const Vec3 to = tangent * random.number(-0.3F, 0.3F) + bitangent * random.number(-0.3F, 0.3F);
        const Vec3 from = to + normal * random.number(0.1F, 3) + tangent * random.number(-3, 3) + bitangent;
        use(from, to);
    }
}

const std::array<Vec3, 3> kNormals{{{0, 1, 0}, normalize({0.3F, 1, -0.2F}), normalize({-1, 0.1F, 0.7F})}};

TEST(Coplanar, ARugIsLitAsIfTheFloorWereNotThere) {
    for (const Vec3 normal : kNormals) {
        const auto scene = [&](bool floor) {
            SceneBuilder b;
            addFloor(b, normal, test::matte(0.8F), floor);
            b.scene.lights = {test::pointLight(normal * 2 + cross(normal, {1, 1, 0}), 5)};
            return b.finish();
        };
        const TracedScene alone(scene(false)), both(scene(true));
        forEachView(normal, [&](Vec3 from, Vec3 to) {
            const float expected = alone.see(from, to);
            EXPECT_GT(expected, 0.1F);
            EXPECT_NEAR(both.see(from, to), expected, 1e-5F * expected);
        });
    }
}

TEST(Coplanar, AMirrorShowsTheSkyNotTheFloorThatItLiesIn) {
    for (const Vec3 normal : kNormals) {
        SceneBuilder b;
        addFloor(b, normal, test::mirror(1), true);
        b.scene.background = {1, 1, 1};
        const TracedScene scene(b.finish());
        forEachView(normal, [&](Vec3 from, Vec3 to) { EXPECT_NEAR(scene.see(from, to), 1, 1e-5F); });
    }
}

TEST(Coplanar, TwoPanesInOnePlaceAreOne) {
    for (const Vec3 normal : kNormals) {
        const auto scene = [&](bool twice) {
            SceneBuilder b;
            addFloor(b, normal, test::glass(), false, twice);
            b.square(normal * -2, normal, 300, b.material(test::emitter({1, 1, 1})));
            Scene made = b.finish();
            made.closed = nullptr; // walls, not the two sides of a solid
            return made;
        };
        const TracedScene one(scene(false)), two(scene(true));
        forEachView(normal,
                    [&](Vec3 from, Vec3 to) { EXPECT_NEAR(two.see(from, to), one.see(from, to), 1e-5F); });
    }
}

} // namespace
} // namespace rtcore
