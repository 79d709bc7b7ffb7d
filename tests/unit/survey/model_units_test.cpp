/// The up axis and the length of a unit, guessed of made shapes. Real models: tests/known_models.
#include "rtcore/survey/model_units.h"

#include "rtcore/accel/builder.h"
#include "rtcore/scene/exporter_habits.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace {

using namespace rtcore;

const std::string kObj = "Wavefront Object Importer";
const std::string kStl = "Stereolithography (STL) Importer";
const std::string kPly = "Stanford Polygon Library (PLY) Importer";
constexpr Vec3 kY{0, 1, 0}, kZ{0, 0, 1};

test::SampleMesh box(Vec3 lo, Vec3 hi) {
    test::SampleMesh cube = test::boxGrid(1);
    cube.map([=](Vec3 p) {
        return Vec3{p.x < 0 ? lo.x : hi.x, p.y < 0 ? lo.y : hi.y, p.z < 0 ? lo.z : hi.z};
    });
    return cube;
}

/// 1 high with z upwards; on the ground, in the middle.
test::SampleMesh table() {
    test::SampleMesh mesh = box({-0.8F, -0.4F, 0.95F}, {0.8F, 0.4F, 1});
    for (const float x : {-0.75F, 0.65F}) {
        for (const float y : {-0.35F, 0.25F}) mesh.append(box({x, y, 0}, {x + 0.1F, y + 0.1F, 0.95F}));
    }
    return mesh;
}

/// A house's walls and floor, 10 x 8 x 3 with z upwards, without a roof; nothing lies at 0.
test::SampleMesh house() {
    test::SampleMesh mesh = box({-5, -4, -1}, {5, 4, -0.8F});
    mesh.append(box({-5, -4, -1}, {-4.7F, 4, 2}));
    mesh.append(box({4.7F, -4, -1}, {5, 4, 2}));
    mesh.append(box({-5, -4, -1}, {5, -3.7F, 2}));
    mesh.append(box({-5, 3.7F, -1}, {5, 4, 2}));
    return mesh;
}

/// z up becomes y up.
test::SampleMesh upright(test::SampleMesh mesh) {
    mesh.map([](Vec3 p) { return Vec3{p.x, p.z, -p.y}; });
    return mesh;
}

test::SampleMesh scaled(test::SampleMesh mesh, float factor) {
    mesh.map([=](Vec3 p) { return p * factor; });
    return mesh;
}

ModelUnits guess(const test::SampleMesh& mesh, const std::string& format, const std::string& exporter = "") {
    BuildOptions options;
    options.threads = 1;
    const KdTree tree = buildKdTree(mesh.view(), options);
    Model model;
    model.mesh = mesh.view();
    return guessModelUnits({format, exporter, {}, {}}, tree, model);
}

/// Boxes that an author named.
struct NamedBoxes {
    void add(std::string_view name, Vec3 lo, Vec3 hi) {
        const test::SampleMesh piece = box(lo, hi);
        buffers.parts.push_back({buffers.addName(name), static_cast<std::uint32_t>(mesh.triangles.size()),
                                 static_cast<std::uint32_t>(piece.triangles.size())});
        mesh.append(piece);
    }
    ModelUnits guess() {
        buffers.vertices = mesh.vertices;
        buffers.triangles = mesh.triangles;
        buffers.shading.resize(mesh.triangles.size());
        buffers.materials.resize(1);
        const KdTree tree = buildKdTree(mesh.view(), {});
        return guessModelUnits({kObj, "", {}, {}}, tree, makeModel(std::move(buffers)));
    }
    test::SampleMesh mesh;
    ModelBuffers buffers;
};

/// A closed room, 4 x 4 x 2.5, with z upwards, whose shape tells nothing; `unit` is its metre.
NamedBoxes room(std::string_view floor, std::string_view wall, std::string_view ceiling, float unit = 1) {
    NamedBoxes all;
    const float x = 2 * unit, high = 2.5F * unit, thick = 0.2F * unit;
    all.add(floor, {-x, -x, -thick}, {x, x, 0});
    all.add(ceiling, {-x, -x, high}, {x, x, high + thick});
    for (const float side : {-x, x - thick}) {
        all.add(wall, {side, -x, 0}, {side + thick, x, high});
        all.add(wall, {-x, side, 0}, {x, side + thick, high});
    }
    return all;
}

TEST(ModelUnits, WhatTheFileSaysIsTaken) {
    const test::SampleMesh mesh = table();
    const KdTree tree = buildKdTree(mesh.view(), {});
    const ModelOrigin origin{kStl, "OpenSCAD", Vec3{-1, 0, 0}, 0.0254};
    Model model;
    model.mesh = mesh.view();
    const ModelUnits units = guessModelUnits(origin, tree, model);
    EXPECT_EQ(units.up, (Vec3{-1, 0, 0}));
    EXPECT_FLOAT_EQ(units.metresPerUnit, 0.0254F);
    EXPECT_EQ(units.upSaid, Said::ByFormat);
    EXPECT_EQ(units.unitSaid, Said::ByFormat);
    EXPECT_FALSE(units.surprising);
    EXPECT_EQ(describe(units).english(),
              "-x is up (the file says so); one unit is 0.0254 m (the file says so)");
}

TEST(ModelUnits, ProgramsHaveTheirHabits) {
    const test::SampleMesh cube = scaled(test::boxGrid(1), 50); // as good one way as another
    const ModelUnits scad = guess(cube, kStl, "OpenSCAD_Model");
    EXPECT_EQ(scad.up, kZ);
    EXPECT_FLOAT_EQ(scad.metresPerUnit, 0.001F);
    EXPECT_TRUE(scad.surprising) << "most models count y upwards";
    EXPECT_EQ(guess(cube, kObj, "Created by FreeCAD <http://www.freecadweb.org>").up, kZ);
    EXPECT_EQ(guess(cube, kObj, "Blender 3.4.1 www.blender.org").up, kY);
    EXPECT_EQ(guess(cube, kPly, "Created by Blender 3.4.1").up, kZ);
    EXPECT_EQ(guess(cube, kObj).up, kY);
    EXPECT_EQ(guess(cube, kStl).up, kZ);
    EXPECT_FLOAT_EQ(guess(cube, kObj, "Generated by Sweet Home 3D").metresPerUnit, 0.01F);
}

// By Assimp's names of their importers.
TEST(ModelUnits, FormatsThatCountZUpwardsAreNotTurned) {
    for (const char* format : {"Blender 3D Importer", "TrueSpace Object Importer", "Quick3D Importer",
                               "3D GameStudio Heightmap (HMP) Importer"})
        EXPECT_EQ(guess(table(), format).up, kZ) << format;
    for (const char* format : {"AC3D Importer", "LightWave/Modo Object Importer", "Milkshape 3D Importer"})
        EXPECT_EQ(guess(upright(table()), format).up, kY) << format;
}

TEST(ModelUnits, AShapeThatIsPlainWinsOverTheFormat) {
    EXPECT_EQ(guess(table(), kObj).up, kZ);
    EXPECT_EQ(guess(table(), kObj).upWhy.english(), "by its shape");
    EXPECT_TRUE(guess(table(), kObj).surprising);
    EXPECT_EQ(guess(upright(table()), kObj).up, kY);
    EXPECT_FALSE(guess(upright(table()), kObj).surprising);
    EXPECT_EQ(guess(upright(table()), kStl, "AssimpScene").up, kY);
    EXPECT_EQ(guess(table(), kStl, "AssimpScene").up, kZ);
}

TEST(ModelUnits, NoShapeWinsOverAProgramThatIsSure) {
    EXPECT_EQ(guess(table(), kObj, "Blender 3.4.1").up, kY);
    EXPECT_EQ(guess(upright(table()), kObj, "Created by FreeCAD").up, kZ);
}

TEST(ModelUnits, TheUnitIsOneThatGivesAThingASensibleSize) {
    const test::SampleMesh mesh = upright(table());
    EXPECT_FLOAT_EQ(guess(mesh, kObj).metresPerUnit, 1);
    EXPECT_FLOAT_EQ(guess(scaled(mesh, 100), kObj).metresPerUnit, 0.01F);
    EXPECT_FLOAT_EQ(guess(scaled(mesh, 100), kObj, "Blender").metresPerUnit, 0.01F);
    EXPECT_EQ(guess(scaled(mesh, 100), kObj, "Blender").unitWhy.english(), "by its size");
    EXPECT_FLOAT_EQ(guess(scaled(mesh, 4000), kObj).metresPerUnit, 0.001F);
    EXPECT_FLOAT_EQ(guess(scaled(mesh, 1000), kStl).metresPerUnit, 0.001F);
    EXPECT_FLOAT_EQ(guess(upright(house()), kObj).metresPerUnit, 1);
    EXPECT_FLOAT_EQ(guess(upright(scaled(house(), 100)), kObj).metresPerUnit, 0.01F);
}

TEST(ModelUnits, FloorsLieAndWallsStand) {
    EXPECT_EQ(room("a", "b", "c").guess().up, kY) << "without names it is as OBJ files are";
    EXPECT_EQ(room("Floor.001", "b", "c").guess().up, kZ);
    EXPECT_EQ(room("a", "outer_walls", "c").guess().up, kZ);
    EXPECT_EQ(room("Fu\xC3\x9F"
                   "boden",
                   "Au\xC3\x9F"
                   "enwand 3",
                   "Decke")
                  .guess()
                  .up,
              kZ);
    EXPECT_EQ(room("podlaha", "st\xC4\x9Bna", "strop").guess().upWhy.english(), "by its floors and walls");
}

TEST(ModelUnits, BuildingsAreAsLargeAsBuildings) {
    for (const auto& [unit, metres] : {std::pair{1.0F, 1.0F}, {100.0F, 0.01F}, {1000.0F, 0.001F}})
        EXPECT_FLOAT_EQ(room("floor", "wall", "ceiling", unit).guess().metresPerUnit, metres);
    EXPECT_FLOAT_EQ(room("tray", "rim", "lid").guess().metresPerUnit, 1);
    EXPECT_GT(room("floor", "wall", "ceiling", 30).guess().metresPerUnit, 0.02F);
    EXPECT_LT(room("floor", "door", "roof", 30).guess().metresPerUnit, 0.02F) << "cars have them, too";
    NamedBoxes land;
    land.add("terrain", {-200, -200, 0}, {200, 200, 1});
    land.add("house", {-5, -4, 1}, {5, 4, 7});
    const ModelUnits units = land.guess();
    EXPECT_EQ(units.up, kZ);
    EXPECT_FLOAT_EQ(units.metresPerUnit, 1) << "no plate with a pin";
}

/// Six walls without names, of a thickness of 1.
test::SampleMesh hollow(Vec3 size) {
    const Vec3 half = size * 0.5F;
    test::SampleMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0F, 1.0F}) {
            Vec3 lo = -half, hi = half;
            (side < 0 ? hi : lo)[axis] = side * (half[axis] - 1);
            mesh.append(box(lo, hi));
        }
    }
    return mesh;
}

TEST(ModelUnits, WhatIsHollowAndHighIsAnOvenRatherThanAHall) {
    EXPECT_FLOAT_EQ(guess(hollow({56, 36, 47}), kObj, "Blender").metresPerUnit, 0.01F);
    EXPECT_FLOAT_EQ(guess(hollow({40, 14, 20}), kObj, "Blender").metresPerUnit, 1) << "a hall";
    // A car: few of its faces are across an axis.
    test::SampleMesh car = hollow({14, 10, 29});
    car.map([](Vec3 p) {
        const float turned = 0.5F;
        const Vec3 once{p.x * std::cos(turned) - p.z * std::sin(turned), p.y,
                        p.x * std::sin(turned) + p.z * std::cos(turned)};
        return Vec3{once.x, once.y * std::cos(turned) - once.z * std::sin(turned),
                    once.y * std::sin(turned) + once.z * std::cos(turned)};
    });
    EXPECT_FLOAT_EQ(guess(car, kObj, "Blender").metresPerUnit, 0.01F);
}

TEST(ModelUnits, WhatHasASkyIsALandscape) {
    const auto insideOf = [](const char* shell) {
        NamedBoxes all;
        all.add(shell, {-250, -250, -1}, {250, 250, 250});
        all.add("city", {-60, -40, 0}, {50, 40, 30});
        return all.guess().metresPerUnit;
    };
    EXPECT_FLOAT_EQ(insideOf("SkyBox"), 1);
    EXPECT_FLOAT_EQ(insideOf("Obloha_01"), 1);
    EXPECT_LT(insideOf("case"), 0.1F);
}

TEST(ModelUnits, AFlatPieceIsAsItsFormatIs) {
    test::SampleMesh quad;
    quad.addTriangle({0, 0, 0}, {4, 0, 0}, {4, 3, 0});
    quad.addTriangle({0, 0, 0}, {4, 3, 0}, {0, 3, 0});
    EXPECT_EQ(guess(quad, kObj).up, kY);
    EXPECT_FALSE(guess(quad, kObj).surprising);
    EXPECT_EQ(guess(upright(quad), kObj).up, kY);
}

TEST(ModelUnits, WhatHasNoSizeGetsAUnitAllTheSame) {
    test::SampleMesh point;
    point.addTriangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    for (const test::SampleMesh& mesh :
         {test::SampleMesh(), point, scaled(table(), 1e-20F), scaled(table(), 1e15F)}) {
        const ModelUnits units = guess(mesh, "");
        EXPECT_GT(units.metresPerUnit, 0);
        EXPECT_TRUE(std::isfinite(units.metresPerUnit));
    }
}

TEST(ModelUnits, TheUserWins) {
    const ModelUnits units = withUserSays({}, kZ, 0.5);
    EXPECT_EQ(units.up, kZ);
    EXPECT_EQ(units.metresPerUnit, 0.5F);
    EXPECT_EQ(units.upSaid, Said::ByUser);
    EXPECT_EQ(withUserSays({}, {}, {}).upSaid, Said::Guessed);
}

} // namespace
