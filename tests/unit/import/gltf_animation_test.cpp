/// Animations of glTF files at a moment, against closed forms.
#include "rtcore/platform/error.h"
#include "unit/import/gltf_builder.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using rtcore::FileImport;
using rtcore::readPose;
using rtcore::Vec3;
using test::GltfBuilder;
using test::Json;
using test::near;

constexpr float kRoot = 0.70710678F; // sine and cosine of an eighth of a turn

FileImport importAt(const GltfBuilder& file, const std::string& pose) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.glb", file.binary());
    rtcore::FileImportOptions options;
    options.pose = *readPose(pose);
    auto read = rtcore::importGltf(folder / "m.glb", options);
    if (!read) throw std::runtime_error("no glTF");
    return std::move(*read);
}

/// The corner (1 0 0) of the square at a moment.
Vec3 cornerAt(const GltfBuilder& file, const std::string& pose) {
    return test::cornerInFile(importAt(file, pose), 0, 1);
}

/// A square of which one value moves, with the keys at 1, 2 and 4 seconds.
template <typename T>
GltfBuilder movingSquare(const std::string& path, const std::string& type, const std::vector<T>& values,
                         const char* interpolation, const std::vector<float>& times = {1, 2, 4}) {
    GltfBuilder file = test::squareFile();
    const int input = file.accessor(times, "SCALAR"), output = file.accessor(values, type);
    Json sampler = {{"input", input}, {"output", output}};
    if (*interpolation != '\0') sampler["interpolation"] = interpolation;
    file.root["animations"] = {{{"name", "Move"},
                                {"samplers", {sampler}},
                                {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}}};
    return file;
}

const std::vector<float> kWays{0, 0, 0, 10, 0, 0, 10, 20, 0};

TEST(GltfAnimations, PassOnTheLineBetweenKeys) {
    const GltfBuilder file = movingSquare("translation", "VEC3", kWays, "");
    EXPECT_TRUE(near(cornerAt(file, "rest"), {1, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "first"), {1, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@0"), {1, 0, 0})) << "held before the first key";
    EXPECT_TRUE(near(cornerAt(file, "Move@1.25"), {3.5F, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "1@3"), {11, 10, 0})) << "by number";
    EXPECT_TRUE(near(cornerAt(file, "Move@99"), {11, 20, 0})) << "held behind the last key";
}

TEST(GltfAnimations, Step) {
    const GltfBuilder file = movingSquare("translation", "VEC3", kWays, "STEP");
    EXPECT_TRUE(near(cornerAt(file, "Move@1.99"), {1, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@2"), {11, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@3.99"), {11, 0, 0}));
}

TEST(GltfAnimations, FollowCubicSplines) {
    // x = t^3, whose tangents are 3 t^2, at 1, 2 and 4: in-tangent, value, out-tangent.
    std::vector<float> values;
    for (const float t : {1.0F, 2.0F, 4.0F})
        for (const float x : {3 * t * t, t * t * t, 3 * t * t}) values.insert(values.end(), {x, 0, 0});
    const GltfBuilder file = movingSquare("translation", "VEC3", values, "CUBICSPLINE");
    EXPECT_TRUE(near(cornerAt(file, "Move@1"), {2, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@1.5"), {4.375F, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@3.5"), {43.875F, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@5"), {65, 0, 0}));
}

TEST(GltfAnimations, TurnAndScale) {
    const std::vector<float> turns{0, 0, 0, 1, 0, 0, kRoot, kRoot, 0, 0, -kRoot, -kRoot};
    const GltfBuilder file = movingSquare("rotation", "VEC4", turns, "LINEAR");
    EXPECT_TRUE(near(cornerAt(file, "Move@1.5"), {kRoot, kRoot, 0})) << "half of a quarter";
    EXPECT_TRUE(near(cornerAt(file, "Move@3"), {0, 1, 0})) << "the other quaternion of the same turn";
    const GltfBuilder scaled =
        movingSquare("scale", "VEC3", std::vector<float>{1, 1, 1, 3, 1, 1, 3, 1, 1}, "");
    EXPECT_TRUE(near(cornerAt(scaled, "Move@1.5"), {2, 0, 0}));
}

TEST(GltfAnimations, TurnByWholeNumbers) {
    const std::vector<std::int16_t> turns{0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 32767, 0};
    EXPECT_TRUE(near(cornerAt(movingSquare("rotation", "VEC4", turns, ""), "Move@2"), {0, 1, 0}, 1e-3F));
}

TEST(GltfAnimations, TakeTheMatrixOfANodeAway) {
    GltfBuilder file = movingSquare("translation", "VEC3", kWays, "");
    file.root["nodes"][0]["matrix"] = {5, 0, 0, 0, 0, 5, 0, 0, 0, 0, 5, 0, 0, 0, 0, 1};
    EXPECT_TRUE(near(cornerAt(file, "rest"), {5, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@4"), {11, 20, 0}));
}

TEST(GltfAnimations, MoveMorphTargets) {
    // Two targets at three keys, as bytes.
    GltfBuilder file =
        movingSquare("weights", "SCALAR", std::vector<std::uint8_t>{0, 0, 255, 0, 255, 51}, "");
    const int up = file.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const int right = file.accessor(std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
    file.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", up}}, {{"POSITION", right}}};
    file.root["meshes"][0]["weights"] = {0, 3};
    EXPECT_TRUE(near(cornerAt(file, "rest"), {4, 0, 0}));
    EXPECT_TRUE(near(cornerAt(file, "Move@1.5"), {1, 0, 0.5F}));
    EXPECT_TRUE(near(cornerAt(file, "Move@4"), {1.2F, 0, 1}));
}

TEST(GltfAnimations, MoveJoints) {
    GltfBuilder file = movingSquare("translation", "VEC3", kWays, "");
    const std::vector<std::uint8_t> joints(16, 0);
    std::vector<float> weights;
    for (int i = 0; i < 4; ++i) weights.insert(weights.end(), {1, 0, 0, 0});
    Json& attributes = file.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = file.accessor(joints, "VEC4");
    attributes["WEIGHTS_0"] = file.accessor(weights, "VEC4");
    file.node(Json::object());
    file.root["nodes"][0]["skin"] = 0;
    file.root["skins"] = {{{"joints", {1}}}};
    file.root["animations"][0]["channels"][0]["target"]["node"] = 1;
    EXPECT_TRUE(near(cornerAt(file, "Move@2"), {11, 0, 0}));
}

TEST(GltfAnimations, AreRefusedByTheNamesThatThereAre) {
    const GltfBuilder file = movingSquare("translation", "VEC3", kWays, "");
    try {
        importAt(file, "Run@1");
        FAIL();
    } catch (const rtcore::FileError& error) {
        EXPECT_NE(std::string(error.what()).find("1 'Move'"), std::string::npos) << error.what();
    }
    EXPECT_THROW(importAt(test::squareFile(), "1@0"), rtcore::FileError);
    const FileImport still = importAt(test::squareFile(), "first");
    EXPECT_NE(test::warningsOf(still).find("no animation"), std::string::npos);
}

TEST(GltfAnimations, PassOverDamagedChannels) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto damage = [](const GltfBuilder& file) {
        const FileImport read = importAt(file, "Move@1.5");
        EXPECT_NE(test::warningsOf(read).find("damaged"), std::string::npos) << file.root["animations"];
        EXPECT_EQ(test::meshOf(read.model).position(0, 1), (Vec3{1, 0, 0}));
    };
    damage(movingSquare("translation", "VEC3", kWays, "", {2, 1, 4}));
    damage(movingSquare("translation", "VEC3", kWays, "", {1, nan, 4}));
    damage(movingSquare("translation", "VEC3", kWays, "", {}));
    damage(movingSquare("translation", "VEC3", kWays, "", {1, 2}));
    damage(movingSquare("translation", "VEC3", kWays, "CUBICSPLINE"));
    damage(movingSquare("translation", "VEC4", std::vector<float>(12), ""));
    damage(movingSquare("translation", "VEC3", std::vector<float>{0, 0, 0, nan, 0, 0, 0, 0, 0}, ""));
    damage(movingSquare("weights", "SCALAR", std::vector<float>{1, 2, 3, 4}, ""));
    for (const char* const member : {"samplers", "sampler", "input", "output", "node"}) {
        for (const Json& value : {Json(99), Json("x"), Json::array(), Json(-1)}) {
            GltfBuilder file = movingSquare("translation", "VEC3", kWays, "");
            Json& animation = file.root["animations"][0];
            const std::string name = member;
            if (name == "samplers")
                animation[name] = value;
            else if (name == "sampler")
                animation["channels"][0][name] = value;
            else if (name == "node")
                animation["channels"][0]["target"][name] = value;
            else
                animation["samplers"][0][name] = value;
            EXPECT_EQ(cornerAt(file, "Move@1.5"), (Vec3{1, 0, 0})) << name << value;
        }
    }
}

} // namespace
