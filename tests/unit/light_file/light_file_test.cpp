// Files of indirect light: what they keep, and of which scenes.

#include "light_file_support.h"

#include "rtcore/scene/photometry.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace rtcore {
namespace {

TEST(LightFile, KeepsEveryBit) {
    const test::TemporaryFolder folder;
    const test::LearnedRoom learned(8, 300);
    const IndirectState state = learned.room.light.state();
    writeLightFile(folder / "room.light", learned.key(), state);
    const LightFile file = readLightFile(folder / "room.light", learned.key());
    EXPECT_EQ(file.match, LightMatch::Same);
    EXPECT_EQ(file.light, state);
    EXPECT_EQ(std::filesystem::file_size(folder / "room.light"),
              64 + 145 * state.irradiance.records.size() + 32 * state.cells.size());
}

TEST(LightFile, KeepsWhatIsNothing) {
    const test::LearnedRoom nothing(0);
    const LightFile file = readLightFile(nothing.bytes(), nothing.key(), "empty.light");
    EXPECT_EQ(file.match, LightMatch::Same);
    EXPECT_EQ(file.light, nothing.room.light.state());
}

TEST(LightFile, TellsWhatOfItHolds) {
    const test::LearnedRoom learned(4);
    LightKey key = learned.key();
    key.light ^= 1;
    LightFile file = readLightFile(learned.bytes(), key, "room.light");
    EXPECT_EQ(file.match, LightMatch::OtherLight);
    EXPECT_EQ(file.light, IndirectState{});
    key.surfaces ^= 1;
    file = readLightFile(learned.bytes(), key, "room.light");
    EXPECT_EQ(file.match, LightMatch::OtherSurfaces);
    EXPECT_EQ(file.light, IndirectState{});
}

TEST(LightFile, IsNotWrittenWhereItWouldBeRefused) {
    const test::TemporaryFolder folder;
    const test::LearnedRoom learned(4);
    IndirectState bad = learned.room.light.state();
    bad.irradiance.records[1].normal = {};
    EXPECT_THROW(writeLightFile(folder / "room.light", learned.key(), bad), FileError);
    EXPECT_FALSE(std::filesystem::exists(folder / "room.light"));
    EXPECT_THROW(readLightFile(folder / "room.light", learned.key()), FileError);
}

TEST(LightFile, IsTheOldOneOrTheNewWheneverItsWriterIsKilled) {
    const test::TemporaryFolder folder;
    const auto path = folder / "room.light";
    const test::LearnedRoom few(2), many(8, 300);
    const LightKey key = few.key();
    const IndirectState small = few.room.light.state(), large = many.room.light.state();
    writeLightFile(path, key, small);
    std::mt19937 random(5);
    for (int i = 0; i < 30; ++i) {
        const pid_t writer = ::fork();
        if (writer == 0) {
            while (true) {
                writeLightFile(path, key, large);
                writeLightFile(path, key, small);
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 6000));
        ASSERT_EQ(::kill(writer, SIGKILL), 0);
        int status = 0;
        ASSERT_EQ(::waitpid(writer, &status, 0), writer);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the writer failed by itself";
        const LightFile file = readLightFile(path, key);
        EXPECT_TRUE(file.light == small || file.light == large);
    }
}

/// A scene with all that may give light.
Scene lively() {
    test::SceneBuilder b;
    Material painted = test::matte(0.7F);
    painted.diffuseTexture = b.texture(2, 1, {{255, 0, 0, 255}, {0, 255, 0, 255}});
    const auto white = b.material(painted), shining = b.material(test::emitter({3, 2, 1}));
    b.box({0, 0, 0}, {1, 1, 1}, white);
    b.box({2, 0, 0}, {3, 1, 1}, shining);
    b.buffers.parts = {{b.buffers.addName("first"), 0, 12}, {b.buffers.addName("second"), 12, 12}};
    b.buffers.colours.assign(b.buffers.normals.size(), kWhite);
    Scene scene = b.finish();
    Light light = test::pointLight({1.5F, 3, 0}, 2);
    light.kind = LightKind::Ies;
    light.right = {1, 0, 0};
    light.photometry = keepPhotometry({{0, 90}, {0, 360}, {2, 1, 2, 1}});
    scene.lights = {test::pointLight({1, 2, 3}, 1), light};
    HdrImage sky(8, 4, {0.5F, 0.6F, 0.7F});
    scene.environments = {std::make_shared<const Environment>(Environment::fromEquirectangular(sky, "sky"))};
    sky.at(3, 2).g = 0.61F;
    scene.environments.push_back(
        std::make_shared<const Environment>(Environment::fromEquirectangular(sky, "sky")));
    scene.fog.kind = FogKind::Homogeneous;
    scene.fog.density = 0.1F;
    return scene;
}

LightKey keyOf(const Scene& scene, const RenderSettings& settings = {},
               const Box3& bounds = {{0, 0, 0}, {3, 1, 1}}) {
    return lightKeyOf(scene, bounds, settings);
}

// A model that is cut open keeps the light of the whole one, unless light falls in.
TEST(LightKey, DiffersWithSectionsThatLetLightIn) {
    Scene scene = lively();
    const LightKey whole = keyOf(scene);
    scene.sections = {{{{1, 0, 0}, {1, 0, 0}}}, SectionLight::Whole, {}};
    EXPECT_EQ(keyOf(scene), whole);
    scene.sections.light = SectionLight::Cut;
    const LightKey cut = keyOf(scene);
    EXPECT_NE(cut, whole);
    scene.sections.planes[0].point.x = 2;
    EXPECT_NE(keyOf(scene), cut) << "elsewhere";
    scene.sections.planes.clear();
    EXPECT_EQ(keyOf(scene), whole);
}

/// The arrays of a model, to be changed.
ModelBuffers buffersOf(const Model& model) {
    const auto copy = [](auto view, auto& to) { to.assign(view.begin(), view.end()); };
    ModelBuffers buffers;
    copy(model.mesh.vertices, buffers.vertices);
    copy(model.mesh.triangles, buffers.triangles);
    copy(model.mesh.shading, buffers.shading);
    copy(model.mesh.normals, buffers.normals);
    copy(model.mesh.texcoords, buffers.texcoords);
    copy(model.mesh.colours, buffers.colours);
    copy(model.materials, buffers.materials);
    copy(model.textures, buffers.textures);
    copy(model.texels, buffers.texels);
    copy(model.blocks, buffers.blocks);
    copy(model.parts, buffers.parts);
    copy(model.strings, buffers.strings);
    return buffers;
}

TEST(LightKey, DiffersWithTheSurfaces) {
    const Scene scene = lively();
    const LightKey key = keyOf(scene);
    const auto expectOther = [&](const Scene& other, const Box3& bounds = {{0, 0, 0}, {3, 1, 1}}) {
        const LightKey now = keyOf(other, {}, bounds);
        EXPECT_NE(now.surfaces, key.surfaces);
        EXPECT_EQ(now.light, key.light);
    };
    const auto expectOtherModel = [&](auto&& change) {
        ModelBuffers buffers = buffersOf(scene.model);
        change(buffers);
        Scene other = scene;
        other.model = makeModel(std::move(buffers));
        expectOther(other);
    };
    expectOtherModel([](ModelBuffers& b) { b.vertices[5].z = std::nextafter(b.vertices[5].z, 9.0F); });
    expectOtherModel([](ModelBuffers& b) { b.vertices[5].z *= -1; });
    expectOtherModel([](ModelBuffers& b) {
        b.vertices[1].x *= -1;
        b.vertices[3].x *= -1; // so far apart that simple sums would not tell
    });
    expectOtherModel([](ModelBuffers& b) { std::swap(b.triangles[2].v[0], b.triangles[2].v[1]); });
    expectOtherModel([](ModelBuffers& b) { std::swap(b.triangles[2], b.triangles[3]); });
    expectOther(scene, {{0, 0, 0}, {3, 1, 1.5F}});
    Scene other = scene;
    other.hiddenParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1});
    expectOther(other);
    other.hiddenParts = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 0});
    EXPECT_EQ(keyOf(other), key);
}

TEST(LightKey, DiffersWithTheLight) {
    const Scene scene = lively();
    const LightKey key = keyOf(scene);
    const auto expectOther = [&](const LightKey& now) {
        EXPECT_EQ(now.surfaces, key.surfaces);
        EXPECT_NE(now.light, key.light);
    };
    using Change = void (*)(Scene&);
    constexpr std::array<Change, 17> kChanges{
        [](Scene& s) { s.lights[0].light.intensity.b = 1.1F; },
        [](Scene& s) { s.lights[0].light.on = 0; },
        [](Scene& s) { s.lights.pop_back(); },
        [](Scene& s) { std::swap(s.lights[0], s.lights[1]); },
        [](Scene& s) {
            s.lights[1].light.photometry = keepPhotometry({{0, 90}, {0, 360}, {2, 1.5, 2, 1.5}});
        },
        [](Scene& s) { s.lights[1].light.photometry = 0; },
        [](Scene& s) { s.materials[0].diffuse.g = 0.71F; },
        [](Scene& s) { s.materials[1].emission.r = 4; },
        [](Scene& s) { s.background.r = 0.1F; },
        [](Scene& s) { s.activeEnvironment = kNoEnvironment; },
        [](Scene& s) { s.activeEnvironment = 1; }, // one texel is another
        [](Scene& s) {
            auto turned = std::make_shared<Environment>(*s.environments[0]);
            turned->turn(30, {0, 1, 0});
            s.environments[0] = turned;
        },
        [](Scene& s) {
            auto bright = std::make_shared<Environment>(*s.environments[0]);
            bright->intensity = 2;
            s.environments[0] = bright;
        },
        [](Scene& s) { s.fog.density = 0.2F; },
        [](Scene& s) { s.fog.emission.g = 0.2F; },
        [](Scene& s) {
            s.up = {0, 0, 1};
        },
        [](Scene& s) {
            s.sky = Sky{};
            s.sky->ground = true;
            s.environments.push_back(s.environments[0]);
            s.activeEnvironment = 2;
            s.ground = makeGround(s.model, {0, 1, 0}, {0.5F, 0.5F, 0.5F});
        },
    };
    for (const Change change : kChanges) {
        Scene other = scene;
        change(other);
        expectOther(keyOf(other));
    }
    const auto expectOtherModel = [&](auto&& change) {
        ModelBuffers buffers = buffersOf(scene.model);
        change(buffers);
        Scene other = scene;
        other.model = makeModel(std::move(buffers));
        expectOther(keyOf(other));
    };
    expectOtherModel([](ModelBuffers& b) { b.texels[1].g = 254; });
    expectOtherModel([](ModelBuffers& b) { b.blocks.resize(1); });
    expectOtherModel([](ModelBuffers& b) { b.textures[0].wrapU = TextureWrap::ClampToEdge; });
    expectOtherModel([](ModelBuffers& b) { b.shading[3].material = 1; });
    expectOtherModel([](ModelBuffers& b) { b.normals[3] = {0, 1, 0}; });
    expectOtherModel([](ModelBuffers& b) { b.texcoords[3].x = 0.25F; });
    expectOtherModel([](ModelBuffers& b) { b.colours[3].r = 0.5F; });
    RenderSettings settings;
    settings.path.bounces = 3;
    expectOther(keyOf(scene, settings));
    settings = {};
    settings.textures = false;
    expectOther(keyOf(scene, settings));
}

TEST(LightKey, IsTheSameForOtherViewsAndNames) {
    const Scene scene = lively();
    const LightKey key = keyOf(scene);
    Scene other = scene;
    other.lights[0].name = "lamp";
    other.lights[0].light.nameOffset = 1;
    other.materials[0].nameOffset = 6;
    other.walk.height = 2;
    other.metresPerUnit = 0.01F;
    // Kept under another number, as in another run of the program.
    keepPhotometry({{0, 45, 90}, {0, 360}, {3, 2, 1, 3, 2, 1}});
    EXPECT_EQ(keyOf(other), key);
    EXPECT_EQ(keyOf(lively()), key);
    RenderSettings settings;
    settings.width = 99;
    settings.antialiasing = 4;
    settings.exposure.key = 1;
    settings.path.samples = 7;
    settings.path.seed = 3;
    settings.integrator = Integrator::Path;
    settings.indirect.mode = IndirectMode::Live;
    settings.areaLights.samples = 9;
    EXPECT_EQ(keyOf(scene, settings), key);
    ModelBuffers buffers = buffersOf(scene.model);
    buffers.cameras.push_back({});
    other = scene;
    other.model = makeModel(std::move(buffers));
    EXPECT_EQ(keyOf(other), key);
}

} // namespace
} // namespace rtcore
