// Scenes against images that were looked at (README.md), and one model in nine formats against itself.
#include "image/picture_compare.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/post/effects.h"
#include "rtcore/survey/default_view.h"
#include "support/one_frame.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using rtcore::LdrImage;

const fs::path kScenes = fs::path(RT_SOURCE_FOLDER) / "tests/image/scenes";
const fs::path kFailures = RT_FAILURE_FOLDER;

LdrImage render(const rtcore::LoadedScene& loaded, const rtcore::Camera& camera,
                const rtcore::RenderSettings& settings) {
    const rtcore::KdRayTracer tracer(loaded.tree, loaded.scene.mesh());
    rtcore::RenderControl control{.threads = 0};
    rtcore::Frame frame;
    rtcore::FrameRenderer renderer;
    renderer.collectAovs(rtcore::effectsNeedAovs(settings));
    EXPECT_TRUE(renderer.render({loaded.scene, tracer, camera, settings}, control, frame));
    return test::develop(frame, settings, test::exposureFor(frame, settings.exposure));
}

void keep(const std::string& name, const LdrImage& result, const LdrImage& reference) {
    fs::create_directories(kFailures);
    rtcore::writeImage(kFailures / (name + ".png"), result);
    rtcore::writeImage(kFailures / (name + "-difference.png"), test::differencePicture(result, reference));
}

void expectSame(const std::string& name, const LdrImage& result, const LdrImage& reference, double mean,
                double block) {
    ASSERT_EQ(result.width, reference.width);
    ASSERT_EQ(result.height, reference.height);
    const test::PictureDifference d = test::comparePictures(result, reference);
    EXPECT_LE(d.mean, mean) << name << ": see " << kFailures;
    EXPECT_LE(d.worstBlock, block) << name << ": see " << kFailures;
    if (d.mean > mean || d.worstBlock > block) keep(name, result, reference);
}

std::vector<fs::path> scenes() {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(kScenes)) {
        if (entry.path().extension() == ".scn") all.push_back(entry.path());
    }
    std::sort(all.begin(), all.end());
    return all;
}

class Picture : public testing::TestWithParam<fs::path> {};

TEST_P(Picture, LooksAsItDid) {
    const fs::path scene = GetParam();
    fs::path reference = scene;
    reference.replace_extension(".png");
    const rtcore::LoadedScene loaded = rtcore::loadScene(scene);
    for (const rtcore::Sentence& warning : loaded.warnings) ADD_FAILURE() << warning.english();
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, loaded.still);
    const LdrImage result = render(loaded, loaded.camera, settings);
    if (std::getenv("RT_UPDATE_REFERENCES") != nullptr) rtcore::writeImage(reference, result);
    ASSERT_TRUE(fs::exists(reference)) << "draw it with RT_UPDATE_REFERENCES=1 and look at it";
    expectSame(scene.stem().string(), result, rtcore::readLdrImage(reference), 0.5, 2);
}

std::string nameOf(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; },
        '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Picture, testing::ValuesIn(scenes()), nameOf);

// One mesh in nine files. All carry positions and triangles; STL has neither shared normals nor texture, so
// only the shape is compared: plain grey, and smooth normals computed with one crease angle.
TEST(NineFiles, GiveTheSamePicture) {
    const char* const folder = std::getenv("RT_TEST_SCENES");
    if (folder == nullptr) GTEST_SKIP() << "skipped: RT_TEST_SCENES names no folder of models";
    rtcore::RenderSettings settings;
    settings.width = 200;
    settings.height = 150;
    settings.textures = false;
    settings.dithering = false;
    LdrImage first;
    rtcore::Camera camera;
    for (const char* const name : {"spot.obj", "spot.ply", "spot_bin.ply", "spot.stl", "spot_bin.stl",
                                   "spot.3ds", "spot.x", "spot.dae", "spot.glb"}) {
        rtcore::LoadedScene loaded = rtcore::loadScene(fs::path(folder) / "spot" / name);
        ASSERT_EQ(loaded.scene.mesh().triangles.size(), 5856U) << name;
        if (first.empty()) camera = loaded.camera;
        for (rtcore::Material& m : loaded.scene.materials) m = rtcore::Material{};
        rtcore::Camera view = camera;
        if (std::string(name) == "spot.3ds") {
            // 3DS has z up, but this file was written with the numbers of a y-up model: it lies on its back.
            const auto turn = [](rtcore::Vec3 v) { return rtcore::Vec3{v.x, v.z, -v.y}; };
            view = {turn(camera.eye), turn(camera.forward), turn(camera.up), camera.horizontalFov, 0};
        }
        loaded.scene.lights = {rtcore::defaultLight(view, loaded.tree.bounds)};
        const LdrImage picture = render(loaded, view, settings);
        if (first.empty()) first = picture;
        expectSame(name, picture, first, 1.0, 12);
    }
}

} // namespace
