/// The first view of models that nobody prepared. They are made by make_strangers.py.
#include "rtcore/io/scene_loader.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/post/develop.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/ground_tracer.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/render/light_meter.h"
#include "rtcore/render/visible_scene.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/survey/closest_hit.h"

#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using rtcore::Vec3;

struct Stranger {
    fs::path path;
    std::string where; ///< "in", "out", "any" or "own"
    double metresPerUnit = 1;
    Vec3 up;
};

std::vector<Stranger> strangersIn(const fs::path& folder) {
    std::vector<Stranger> all;
    std::ifstream list(folder / "strangers.txt");
    for (std::string line; std::getline(list, line);) {
        if (line.starts_with("#")) continue;
        std::istringstream words(line);
        Stranger stranger;
        std::string file, up;
        words >> file >> stranger.where >> stranger.metresPerUnit >> up;
        stranger.path = folder / file;
        stranger.up = rtcore::axisNamed("+" + up).value();
        all.push_back(stranger);
    }
    return all;
}

/// In feet, which few write; without names and thickness; a part on its side: what neither name nor shape
/// tells has to be said.
bool isSaid(const Stranger& stranger) {
    const std::set<std::string> all{"house4_ft.obj", "room_single_obj.obj", "housing_obj.obj"};
    return all.contains(stranger.path.filename().string());
}

rtcore::LoadedScene load(const Stranger& stranger) {
    rtcore::LoadOptions options;
    options.build.method = rtcore::BuildMethod::Fast;
    if (isSaid(stranger)) {
        options.import.up = stranger.up;
        options.import.metresPerUnit = stranger.metresPerUnit;
    }
    options.lighting.usual = rtcore::LightingPreset::Sky;
    return rtcore::loadScene(stranger.path, options);
}

/// An image of 16:9.
struct Image {
    explicit Image(const rtcore::Camera& camera)
        : eye(camera.eye), forward(normalize(camera.forward)), right(normalize(cross(forward, camera.up))),
          up(cross(right, forward)), across(std::tan(camera.horizontalFov * 3.14159265F / 360)) {}
    /// -1..1 both, from left to right and from below; z: the distance.
    Vec3 at(Vec3 p) const {
        const Vec3 way = p - eye;
        const float distance = dot(way, forward);
        return {dot(way, right) / (distance * across), dot(way, up) / (distance * across) * 16 / 9, distance};
    }
    Vec3 direction(float x, float y) const {
        return normalize(forward + right * (x * across) + up * (y * across * 9 / 16));
    }
    Vec3 eye, forward, right, up;
    float across;
};

void expectSeenWhole(const rtcore::LoadedScene& scene) {
    const rtcore::Mesh& mesh = scene.scene.model.mesh;
    const rtcore::Box3 bounds = rtcore::subjectOf(mesh, rtcore::axesOf(scene.scene)).bounds;
    EXPECT_FALSE(bounds.contains(scene.camera.eye));
    const Image image(scene.camera);
    float left = 9, right = -9, low = 9, high = -9;
    for (const rtcore::Vertex& vertex : mesh.vertices) {
        if (!bounds.contains(vertex.position())) continue;
        const Vec3 p = image.at(vertex.position());
        ASSERT_GT(p.z, 0);
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    EXPECT_GE(left, -1);
    EXPECT_LE(right, 1);
    EXPECT_GE(low, -1);
    EXPECT_LE(high, 1);
    const float size = std::max(right - left, high - low) / 2;
    EXPECT_GE(size, 0.5F);
    EXPECT_LE(size, 0.97F);
    // Nothing but itself and what it stands on is before its middle.
    const Vec3 way = bounds.centre() - scene.camera.eye;
    const auto hit = rtcore::closestHit(scene.tree, mesh, scene.camera.eye, way);
    if (hit && hit->t < 1) {
        rtcore::Box3 near = bounds;
        near.lo = near.lo - Vec3{1, 1, 1} * (0.005F * bounds.diagonal());
        near.hi = near.hi + Vec3{1, 1, 1} * (0.005F * bounds.diagonal());
        EXPECT_TRUE(near.contains(scene.camera.eye + way * hit->t));
    }
}

void expectStandsInRoom(const rtcore::LoadedScene& scene) {
    const rtcore::Axes axes = rtcore::axesOf(scene.scene);
    const rtcore::Mesh& mesh = scene.scene.model.mesh;
    const auto floor = rtcore::closestHit(scene.tree, mesh, scene.camera.eye, -axes.up);
    ASSERT_TRUE(floor);
    EXPECT_GE(floor->t, 1.4F * axes.metre);
    EXPECT_LE(floor->t, 1.8F * axes.metre);
    EXPECT_NEAR(dot(normalize(scene.camera.forward), axes.up), 0, 0.01);
    const Image image(scene.camera);
    int seen = 0;
    for (int y = -4; y <= 4; ++y) {
        for (int x = -4; x <= 4; ++x) {
            const Vec3 way = image.direction(static_cast<float>(x) / 12, static_cast<float>(y) / 12);
            const auto hit = rtcore::closestHit(scene.tree, mesh, scene.camera.eye, way);
            if (!hit) continue;
            ++seen;
            EXPECT_GE(hit->t, 0.4F * axes.metre);
        }
    }
    EXPECT_GT(seen, 40);
}

bool isInside(const rtcore::LoadedScene& scene) {
    const rtcore::Box3 all = scene.scene.model.mesh.bounds();
    return all.contains(scene.camera.eye) && scene.camera.horizontalFov > 60;
}

void expectGoodView(const Stranger& stranger) {
    const rtcore::LoadedScene scene = load(stranger);
    const bool inside = isInside(scene);
    EXPECT_EQ(scene.units.up, stranger.up);
    EXPECT_FLOAT_EQ(scene.units.metresPerUnit, static_cast<float>(stranger.metresPerUnit));
    EXPECT_EQ(scene.ownCamera, stranger.where == "own");
    if (stranger.where == "own") return;
    if (stranger.where != "any") {
        EXPECT_EQ(inside, stranger.where == "in");
    }
    inside ? expectStandsInRoom(scene) : expectSeenWhole(scene);
}

std::string saidOf(const rtcore::LoadedScene& scene) {
    std::string all;
    for (const rtcore::Sentence& warning : scene.warnings) all += warning.english() + "\n";
    return all;
}

/// Statistics of the model's own pixels, as a display shows them, 0..255.
struct Shown {
    double mean = 0, black = 0, white = 0; ///< the last two as parts of all
    double albedo = 0;                     ///< the mean of its surfaces
};

Shown shown(const rtcore::LoadedScene& loaded) {
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, loaded.live);
    settings.width = 80; // as its light is measured: an image of more pixels takes seconds to light
    settings.height = 45;
    settings.antialiasing = 1;
    const rtcore::KdTree tree = rtcore::visibleTree(loaded.tree, loaded.scene);
    const auto surfaces = std::make_shared<const rtcore::KdRayTracer>(tree, loaded.scene.model.mesh);
    const auto tracer = rtcore::withGround(surfaces, loaded.scene);
    const rtcore::View view{loaded.scene, *tracer, loaded.camera, settings};
    rtcore::RenderControl control{.threads = 1};
    rtcore::Frame frame;
    rtcore::ImageRenderers renderers;
    EXPECT_TRUE(renderers.of(settings.integrator).render(view, control, {.aovs = true}, frame));
    rtcore::PictureDeveloper developer;
    rtcore::LdrImage image;
    const float exposure = developer.exposure(frame, settings, rtcore::LightMeter().white(view, control), 1);
    developer.develop(frame, settings, exposure, 1, image);
    const rtcore::CameraRays rays(loaded.camera, settings.width, settings.height);
    Shown sum;
    int count = 0;
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            const rtcore::Ray ray = rays.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            if (!rtcore::closestHit(tree, loaded.scene.model.mesh, ray.origin, ray.direction)) continue;
            const rtcore::Rgba8 p = image.at(x, y);
            const double code = 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b;
            sum.mean += code;
            sum.black += code < 6 ? 1 : 0;
            sum.white += code > 252 ? 1 : 0;
            const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(settings.width) +
                                   static_cast<std::size_t>(x);
            sum.albedo += static_cast<double>(luminance(frame.aovs.pixels()[at].albedo));
            ++count;
        }
    }
    const double all = std::max(count, 1);
    return {sum.mean / all, sum.black / all, sum.white / all, sum.albedo / all};
}

/// In the light of the first minute. Surfaces that are white themselves are shown lighter: plaster, and parts
/// without a material. Those that are black themselves are shown black, too.
void expectGoodLight(const Shown& seen, bool inside) {
    EXPECT_GE(seen.mean, seen.albedo < 0.1 ? 20 : 70) << "albedo " << seen.albedo;
    EXPECT_LE(seen.mean, seen.albedo > 0.4 ? 236 : 190) << "albedo " << seen.albedo;
    EXPECT_LE(seen.black, seen.albedo < 0.1 ? 1 : 0.03);
    // Lights under ceilings have bright pools of light above them.
    EXPECT_LE(seen.white, inside ? 0.05 : 0.03);
}

/// The folder with the models; empty where they cannot be made.
class Strangers : public testing::Test {
  protected:
    void SetUp() override {
        const std::string python = "/usr/bin/python3";
        if (!fs::exists(python)) GTEST_SKIP() << "python3 is missing: the models cannot be made";
        const fs::path script = fs::path(RT_SOURCE_FOLDER) / "tests/strangers/make_strangers.py";
        const test::ProgramResult made = test::runProgram(python, {script.string(), folder.path().string()});
        ASSERT_EQ(made.exitCode, 0) << made.error;
        all = strangersIn(folder.path());
        ASSERT_GE(all.size(), 50U);
    }
    rtcore::LoadedScene loadNamed(const std::string& file) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Stranger& stranger) {
            return stranger.path.filename() == file;
        });
        EXPECT_NE(found, all.end()) << file;
        return load(*found);
    }
    test::TemporaryFolder folder;
    std::vector<Stranger> all;
};

TEST_F(Strangers, AreSeenFromTheRightPlace) {
    for (const Stranger& stranger : all) {
        SCOPED_TRACE(stranger.path.filename().string());
        expectGoodView(stranger);
    }
}

TEST_F(Strangers, AreShownInGoodLight) {
    for (const Stranger& stranger : all) {
        SCOPED_TRACE(stranger.path.filename().string());
        expectGoodLight(shown(load(stranger)), stranger.where == "in");
    }
}

std::vector<fs::path> otherPeoplesModels() {
    std::vector<fs::path> all;
    const char* const scenes = std::getenv("RT_TEST_SCENES");
    std::ifstream list(fs::path(RT_SOURCE_FOLDER) / "tests/strangers/others.txt");
    for (std::string where, file; list >> where;) {
        std::getline(list >> std::ws, file);
        if (where.starts_with("#") || (where == "scenes" && scenes == nullptr)) continue;
        const fs::path path = fs::path(where == "assimp" ? "/usr/share/assimp/models" : scenes) / file;
        if (fs::exists(path)) all.push_back(path);
    }
    return all;
}

TEST(OtherPeoplesModels, AreSeenWellToo) {
    const std::vector<fs::path> all = otherPeoplesModels();
    if (all.empty()) GTEST_SKIP() << "none of tests/strangers/others.txt is there";
    for (const fs::path& path : all) {
        SCOPED_TRACE(path.string());
        const rtcore::LoadedScene scene = load({path, {}, 1, {}});
        expectGoodLight(shown(scene), isInside(scene));
        if (scene.ownCamera) continue;
        isInside(scene) ? expectStandsInRoom(scene) : expectSeenWhole(scene);
    }
}

TEST_F(Strangers, StrayCamerasAreBookmarks) {
    for (const char* const file : {"stray_far.glb", "stray_past.glb", "stray_near.glb"}) {
        const rtcore::LoadedScene scene = loadNamed(file);
        ASSERT_EQ(scene.bookmarks.size(), 1U) << file;
        EXPECT_EQ(scene.bookmarks[0].name, "Camera");
        EXPECT_NE(saidOf(scene).find("its camera 'Camera' shows little or nothing of the model"),
                  std::string::npos)
            << file;
    }
    EXPECT_TRUE(loadNamed("own_camera.glb").bookmarks.empty());
}

TEST_F(Strangers, LightsThatReachNothingAreNotAlone) {
    const rtcore::LoadedScene scene = loadNamed("stray_lamp.glb");
    EXPECT_NE(saidOf(scene).find("own lights reach nothing"), std::string::npos);
    EXPECT_TRUE(scene.scene.sky);
    EXPECT_EQ(scene.scene.lights.back().name, "Bulb") << "it is kept";
    const rtcore::LoadedScene lit = loadNamed("room_lamp.glb");
    EXPECT_FALSE(lit.scene.sky);
    EXPECT_EQ(lit.scene.lights.size(), 1U);
}

TEST_F(Strangers, WhatNoLightReachesIsLitFromTheEye) {
    const rtcore::LoadedScene scene = loadNamed("crawl_space.glb");
    EXPECT_NE(saidOf(scene).find("no light reaches what is seen"), std::string::npos);
    EXPECT_EQ(scene.scene.lights.back().name, rtcore::kHeadlightName);
    for (const char* const file : {"room_closed.glb", "room.glb", "house1_plot.glb"})
        EXPECT_EQ(saidOf(loadNamed(file)).find("no light reaches"), std::string::npos) << file;
}

TEST_F(Strangers, SkiesAroundThemAreHidden) {
    for (const char* const file :
         {"dome_house.glb", "dome_lit_house.glb", "sphere_car.glb", "skybox_figure.glb"}) {
        const rtcore::LoadedScene scene = loadNamed(file);
        ASSERT_NE(scene.scene.hiddenParts, nullptr) << file;
        EXPECT_NE(saidOf(scene).find("is hidden, since it would keep the light out"), std::string::npos);
        EXPECT_TRUE(scene.scene.sky) << file;
    }
    EXPECT_EQ(loadNamed("hall.glb").scene.hiddenParts, nullptr) << "walls are no sky";
}

TEST_F(Strangers, SkiesThatShowAPictureAreEnvironments) {
    const rtcore::LoadedScene loaded = loadNamed("sky_faces.glb");
    EXPECT_NE(saidOf(loaded).find("lights it as an environment map"), std::string::npos) << saidOf(loaded);
    EXPECT_FALSE(loaded.scene.sky);
    ASSERT_NE(loaded.scene.environment(), nullptr);
    ASSERT_EQ(loaded.scene.environmentFiles.size(), 1U);
    EXPECT_EQ(loaded.scene.environmentFiles[0].parts.size(), 6U);
    const auto seen = [&](rtcore::Vec3 to) {
        return loaded.scene.environment()->radiance(to, rtcore::TexelFilter::Nearest);
    };
    EXPECT_GT(seen({0, 1, 0}).b, 2 * seen({0, 1, 0}).r) << "blue above";
    EXPECT_GT(seen({0, -1, 0}).r, seen({0, -1, 0}).b) << "brown below";
    EXPECT_GT(seen({1, 0, 0}).r, 2 * seen({0, 1, 0}).r) << "light around";
}

} // namespace
