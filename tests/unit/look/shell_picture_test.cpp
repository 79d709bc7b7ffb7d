#include "rtcore/look/shell_picture.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace {

using rtcore::Colour;
using rtcore::TexelFilter;
using rtcore::Vec3;

/// A block in a large box whose sides give off such light: above, around, below.
struct Boxed {
    explicit Boxed(Colour above, Colour around, Colour below) : traced(sceneOf(above, around, below)) {}

    static rtcore::Scene sceneOf(Colour above, Colour around, Colour below) {
        test::SceneBuilder b;
        b.box({-1, -1, -1}, {1, 1, 1}, b.material(test::matte(0.5F)));
        const auto side = [&](Vec3 to, Colour radiance) {
            b.square(to * 50.0F, -to, 50, b.material(test::emitter(radiance)));
        };
        side({0, 1, 0}, above);
        side({0, -1, 0}, below);
        for (const Vec3 to : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) side(to, around);
        rtcore::Scene scene = b.finish();
        // The block has twelve triangles.
        const auto parts = std::make_shared<std::vector<rtcore::ModelPart>>();
        parts->push_back({0, 0, 12});
        parts->push_back({0, 12, static_cast<std::uint32_t>(scene.model.mesh.triangles.size()) - 12});
        scene.model.parts = *parts;
        static std::vector<std::shared_ptr<const void>> kept;
        kept.push_back(parts);
        return scene;
    }
    auto picture() const {
        const std::vector<std::uint8_t> pieces{0, 1};
        return rtcore::pictureOfShell(traced.scene, traced.tree, pieces, "sky");
    }

    test::TracedScene traced;
};

TEST(ShellPicture, ShowsWhatTheShellGivesOff) {
    const Colour blue{0.2F, 0.4F, 0.9F}, grey{0.5F, 0.5F, 0.5F}, brown{0.2F, 0.1F, 0.05F};
    const auto picture = Boxed(blue, grey, brown).picture();
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->name(), "sky");
    const auto seen = [&](Vec3 to) { return picture->radiance(to, TexelFilter::Nearest); };
    EXPECT_EQ(seen({0.1F, 1, -0.2F}), blue);
    EXPECT_EQ(seen({0.1F, -1, -0.2F}), brown);
    for (const Vec3 to : {Vec3{1, 0.2F, 0}, Vec3{-1, 0, 0.3F}, Vec3{0.2F, 0.5F, 1}, Vec3{0, -0.4F, -1}})
        EXPECT_EQ(seen(to), grey);
}

TEST(ShellPicture, IsNoneWhereItIsEvenOrDark) {
    const Colour blue{0.2F, 0.4F, 0.9F};
    EXPECT_FALSE(Boxed(blue, blue, blue).picture());
    EXPECT_FALSE(Boxed({}, {}, {}).picture());
}

/// Also of a model that has no parts: its own lights are no shell.
TEST(ShellPicture, IsNoneWithoutPieces) {
    Boxed boxed({1, 1, 1}, {0.5F, 0.5F, 0.5F}, {0.1F, 0.1F, 0.1F});
    EXPECT_TRUE(boxed.picture());
    const std::vector<std::uint8_t> none{0, 0};
    const rtcore::Scene& scene = boxed.traced.scene;
    EXPECT_FALSE(rtcore::pictureOfShell(scene, boxed.traced.tree, none, "sky"));
    rtcore::Scene whole = scene;
    whole.model.parts = {};
    EXPECT_FALSE(rtcore::pictureOfShell(whole, boxed.traced.tree, {}, "sky"));
}

} // namespace
