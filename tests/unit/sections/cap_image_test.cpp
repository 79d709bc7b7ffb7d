// Caps in images, pixel by pixel, against rays that meet the plane.
#include "rtcore/sections/cap_image.h"

#include "rtcore/render/camera_rays.h"
#include "rtcore/sections/cap_painter.h"
#include "support/random_numbers.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace {

using namespace rtcore;
using test::Solids;

constexpr Colour kRed{1, 0, 0}, kBlue{0, 0, 1};
constexpr int kWidth = 120, kHeight = 90;
constexpr Rgba8 kBefore{10, 200, 30, 255};

Camera cameraAt(Vec3 eye, Vec3 target, CameraKind kind = CameraKind::Perspective) {
    Camera camera;
    camera.eye = eye;
    camera.forward = target - eye;
    camera.up = {0, 1, 0};
    camera.horizontalFov = 50;
    camera.kind = kind;
    camera.orthographicWidth = 6;
    return camera;
}

LdrImage painted(const Scene& scene, const Camera& camera) {
    LdrImage image(kWidth, kHeight, kBefore);
    CapPainter().paint(scene, camera, image);
    return image;
}

bool isUntouched(const LdrImage& image) {
    return std::ranges::all_of(image.pixels, [](const Rgba8& pixel) { return pixel == kBefore; });
}

/// A box of red, in it one of blue, cut at z = 0 from above.
Scene nested() {
    Solids solids;
    solids.begin("outer", kRed);
    solids.box({-1, -1, -1}, {1, 1, 1});
    solids.begin("inner", kBlue);
    solids.box({-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F});
    Scene scene = solids.scene();
    scene.sections.planes = {{{0, 0, 0}, {0, 0, 1}}};
    return scene;
}

TEST(CapImage, ShowsTheInnerSolidAndDarkEdges) {
    const LdrImage image = painted(nested(), cameraAt({0, 0, 4}, {0, 0, 0}));
    EXPECT_EQ(image.at(kWidth / 2, kHeight / 2), (Rgba8{0, 0, 255, 255}));
    // 1 is 120 / (2 tan 25 degrees) / 4 = 32.2 pixels
    EXPECT_EQ(image.at(kWidth / 2 + 24, kHeight / 2), (Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(image.at(kWidth / 2 + 40, kHeight / 2), kBefore);
    const Rgba8 edge = image.at(kWidth / 2 + 32, kHeight / 2);
    EXPECT_LT(edge.r, 140) << "dark";
    EXPECT_LT(edge.g, 100);
}

TEST(CapImage, IsOfTheSideThatWasTakenAway) {
    EXPECT_TRUE(isUntouched(painted(nested(), cameraAt({0, 0, -4}, {0, 0, 0}))));
    EXPECT_TRUE(isUntouched(painted(nested(), cameraAt({0, 0, 4}, {0, 0, 8})))) << "behind";
    Scene scene = nested();
    scene.sections.caps.colours = CapColours::None;
    EXPECT_TRUE(isUntouched(painted(scene, cameraAt({0, 0, 4}, {0, 0, 0}))));
    scene.sections.planes.clear();
    EXPECT_TRUE(isUntouched(painted(scene, cameraAt({0, 0, 4}, {0, 0, 0}))));
}

TEST(CapImage, HasOneColourAndLinesWhereAsked) {
    Scene scene = nested();
    scene.sections.caps = {CapColours::One, {1, 1, 1}, false};
    EXPECT_EQ(painted(scene, cameraAt({0, 0, 4}, {0, 0, 0})).at(kWidth / 2, kHeight / 2),
              (Rgba8{255, 255, 255, 255}));
    scene.sections.caps.hatched = true;
    const LdrImage image = painted(scene, cameraAt({0, 0, 4}, {0, 0, 0}));
    int dark = 0;
    for (int x = 0; x < 8; ++x) dark += image.at(kWidth / 2 - 4 + x, kHeight / 2).r < 220 ? 1 : 0;
    EXPECT_GE(dark, 2);
    EXPECT_LE(dark, 4);
}

TEST(CapImage, HasTheMeanColourOfATexture) {
    Scene scene = nested();
    const std::array<Rgba8, 4> texels{
        {{0, 0, 0, 255}, {255, 0, 0, 255}, {255, 255, 255, 255}, {0, 0, 0, 255}}};
    const std::array<Texture, 2> textures{
        {{.width = 1, .height = 1}, {.firstTexel = 1, .width = 1, .height = 2}}};
    scene.model.texels = texels;
    scene.model.textures = textures;
    scene.materials[1].diffuse = {1, 0.5F, 1};
    scene.materials[1].diffuseTexture = 1;
    const auto middle = [&] {
        return painted(scene, cameraAt({0, 0, 4}, {0, 0, 0})).at(kWidth / 2, kHeight / 2);
    };
    const auto code = [](float light) {
        return static_cast<std::uint8_t>(std::lround(255 * srgbEncode(light)));
    };
    EXPECT_EQ(middle(), (Rgba8{255, code(0.25F), code(0.5F), 255}));
    scene.materials[1].diffuseTexture = 0;
    EXPECT_EQ(middle(), (Rgba8{0, 0, 0, 255}));
}

/// By each pixel's own ray: where it comes to the plane, if it comes from the side that was taken away.
void compareWithRays(const Scene& scene, const Camera& camera, const auto& isSolid) {
    const LdrImage image = painted(scene, camera);
    const CameraRays rays(camera, kWidth, kHeight);
    const SectionPlane plane = scene.sections.planes[0];
    const Vec3 n = normalize(plane.normal);
    int caps = 0, wrong = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto solidAt = [&](float dx, float dy) {
                const Ray ray = rays.at(static_cast<float>(x) + dx, static_cast<float>(y) + dy);
                const float speed = dot(n, ray.direction), t = dot(n, plane.point - ray.origin) / speed;
                return speed < 0 && t > 0 && isSolid(ray.origin + ray.direction * t);
            };
            const bool middle = solidAt(0.5F, 0.5F);
            bool edge = false; // a line lies there
            for (float dx = -1; dx <= 2; dx += 0.25F)
                for (float dy = -1; dy <= 2; dy += 0.25F) edge = edge || solidAt(dx, dy) != middle;
            if (edge) continue;
            caps += middle ? 1 : 0;
            wrong += (image.at(x, y) == kBefore) == middle ? 1 : 0;
        }
    }
    EXPECT_GT(caps, 40);
    EXPECT_EQ(wrong, 0);
}

TEST(CapImage, LiesWhereRaysMeetThePlane) {
    const auto inBox = [](Vec3 p) { return std::fabs(p.x) < 1 && std::fabs(p.y) < 1 && std::fabs(p.z) < 1; };
    test::Random random(5);
    Solids solids;
    solids.begin("box", kRed);
    solids.box({-1, -1, -1}, {1, 1, 1});
    Scene scene = solids.scene();
    for (int round = 0; round < 20; ++round) {
        const Vec3 n = random.unitVector();
        scene.sections.planes = {{random.vector(0.3F), n}};
        Vec3 eye = random.unitVector() * random.number(1.2F, 4);
        if (dot(n, eye - scene.sections.planes[0].point) < 0.3F) eye = eye + n * 3.0F;
        if (dot(n, normalize(eye)) < 0.3F) continue; // too flat for a box to be seen
        compareWithRays(
            scene, cameraAt(eye, {}, round % 3 == 0 ? CameraKind::Orthographic : CameraKind::Perspective),
            inBox);
    }
}

// Where the plane goes on behind the eye.
TEST(CapImage, OfAFloorReachesBehindTheCamera) {
    Solids solids;
    solids.begin("slab", kRed);
    solids.box({-100, -100, -1}, {100, 100, 1});
    Scene scene = solids.scene();
    scene.sections.planes = {{{0, 0, 0}, {0, 0, 1}}};
    Camera camera = cameraAt({0, 0, 1.7F}, {0, 10, 1.5F});
    camera.up = {0, 0, 1};
    compareWithRays(scene, camera, [](Vec3 p) { return std::fabs(p.x) < 100 && std::fabs(p.y) < 100; });
}

// Of more pixels than are painted at once.
TEST(CapImage, OfALargeImageIsWhole) {
    constexpr int kLarge = 4200;
    const Scene scene = nested();
    LdrImage image(kLarge, kLarge, kBefore);
    CapPainter().paint(scene, cameraAt({0, 0, 1.6F}, {0, 0, 0}), image);
    const int joint = (1 << 24) / kLarge, middle = kLarge / 2;
    for (int y = 10; y < kLarge - 10; ++y) ASSERT_NE(image.at(middle, y), kBefore) << y;
    EXPECT_EQ(image.at(middle, joint - 1), image.at(middle, joint));
    EXPECT_EQ(image.at(middle, joint), (Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(image.at(middle, joint + 1), (Rgba8{255, 0, 0, 255}));
}

// A lid that is left whole above the cut: it hides the caps below it, and not those beside it.
TEST(CapPainter, PartsThatAreLeftWholeHideCaps) {
    Solids solids;
    solids.begin("block", kRed);
    solids.box({-1, -1, -1}, {1, 1, 1});
    solids.begin("lid", kBlue);
    solids.box({-0.5F, -0.5F, 2}, {0.5F, 0.5F, 2.1F});
    Scene scene = solids.scene();
    scene.sections.planes = {{{0, 0, 0}, {0, 0, 1}}};
    const Camera above = cameraAt({0, 0, 6}, {0, 0, 0}, CameraKind::Orthographic);
    CapPainter painter;
    const auto at = [&](const Camera& camera, int x, int y) {
        LdrImage image(kWidth, kHeight, kBefore);
        painter.paint(scene, camera, image);
        return image.at(x, y);
    };
    const int x = kWidth / 2, y = kHeight / 2, beside = x + 15; // 20 pixels are 1
    const Rgba8 red{255, 0, 0, 255};
    EXPECT_EQ(at(above, x, y), red) << "the lid is taken away";
    scene.uncutParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1});
    EXPECT_EQ(at(above, x, y), kBefore);
    EXPECT_EQ(at(above, beside, y), red);
    EXPECT_EQ(at(cameraAt({0, 0, 1.5F}, {0, 0, 0}), x, y), red) << "it is behind the camera";
    scene.hiddenParts = scene.uncutParts;
    EXPECT_EQ(at(above, x, y), red) << "it is hidden";
}

TEST(CapPainter, SeesWhatChanges) {
    CapPainter painter;
    Scene scene = nested();
    const Camera camera = cameraAt({0, 0, 4}, {0, 0, 0});
    const auto middle = [&] {
        LdrImage image(kWidth, kHeight, kBefore);
        painter.paint(scene, camera, image);
        return image.at(kWidth / 2, kHeight / 2);
    };
    EXPECT_EQ(middle(), (Rgba8{0, 0, 255, 255}));
    scene.hiddenParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1});
    EXPECT_EQ(middle(), (Rgba8{255, 0, 0, 255}));
    scene.materials[0].diffuse = {0, 1, 0};
    EXPECT_EQ(middle(), (Rgba8{0, 255, 0, 255}));
    scene.uncutParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{1, 0});
    EXPECT_EQ(middle(), kBefore) << "what is left whole has no cap";
    scene.uncutParts = nullptr;
    scene.sections.planes[0].point.z = 2;
    EXPECT_EQ(middle(), kBefore);
    scene = nested();
    EXPECT_EQ(middle(), (Rgba8{0, 0, 255, 255})) << "another model";
}

} // namespace
