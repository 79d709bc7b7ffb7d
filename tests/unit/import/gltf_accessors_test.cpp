/// Lists of numbers of every kind, and damaged ones.
#include "unit/import/gltf_builder.h"

namespace {

using namespace rtcore;
using test::GltfBuilder;
using test::Json;
using test::meshOf;

/// The square with positions by this accessor, which may be damaged.
FileImport squareBy(GltfBuilder& file, int positions) {
    const int corners = file.accessor(test::kSquareCorners, "SCALAR");
    file.show({{"attributes", {{"POSITION", positions}}}, {"indices", corners}});
    return file.import();
}

void expectSquare(const FileImport& read, float side = 1) {
    const Mesh mesh = meshOf(read.model);
    ASSERT_EQ(mesh.triangles.size(), 2U);
    const float corners[4][2] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    for (int i = 0; i < 3; ++i) {
        const Vec3 p = mesh.position(0, i);
        EXPECT_EQ(p, (Vec3{corners[i][0], corners[i][1], 0}));
    }
    EXPECT_EQ(mesh.position(1, 2), (Vec3{0, side, 0}));
}

template <typename T>
FileImport squareOf(T one, bool normalized) {
    GltfBuilder file;
    std::vector<T> numbers;
    for (const float v : test::kSquare) numbers.push_back(v > 0 ? one : T{0});
    return squareBy(file, file.accessor(numbers, "VEC3", normalized));
}

TEST(GltfAccessors, WholeNumbersArePositions) {
    expectSquare(squareOf<std::uint16_t>(7, false), 7);
    expectSquare(squareOf<std::uint8_t>(7, false), 7);
    expectSquare(squareOf<std::int8_t>(-7, false), -7);
    expectSquare(squareOf<std::int16_t>(-7, false), -7);
    expectSquare(squareOf<std::uint32_t>(7, false), 7);
}

TEST(GltfAccessors, NormalizedOnesDivideByTheLargest) {
    expectSquare(squareOf<std::uint8_t>(255, true));
    expectSquare(squareOf<std::int8_t>(127, true));
    expectSquare(squareOf<std::int8_t>(-128, true), -1);
    expectSquare(squareOf<std::uint16_t>(65535, true));
    expectSquare(squareOf<std::int16_t>(-32768, true), -1);
    expectSquare(squareOf<std::uint8_t>(51, true), 0.2F);
}

TEST(GltfAccessors, StridesSkipWhatLiesBetween) {
    GltfBuilder file;
    std::string bytes(3, 'x'); // an offset that is no multiple of anything
    for (std::size_t i = 0; i < 4; ++i) {
        bytes.append(reinterpret_cast<const char*>(test::kSquare.data() + 3 * i), 12);
        if (i < 3) bytes += "between"; // behind the last one there is nothing
    }
    expectSquare(squareBy(file, file.accessor(Json{{"bufferView", file.view(bytes, 19)},
                                                   {"byteOffset", 3},
                                                   {"componentType", 5126},
                                                   {"count", 4},
                                                   {"type", "VEC3"}})));
}

TEST(GltfAccessors, SparseOnesReplaceSome) {
    for (const bool zeros : {false, true}) {
        GltfBuilder file;
        std::vector<float> wrong = test::kSquare;
        wrong[3] = wrong[6] = 9;
        Json stated{{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}};
        std::vector<std::uint8_t> which{1, 2};
        std::vector<float> values(test::kSquare.begin() + 3, test::kSquare.begin() + 9);
        if (zeros) {
            which.push_back(3);
            values.insert(values.end(), {0, 1, 0});
        } else {
            stated["bufferView"] =
                file.view({reinterpret_cast<const char*>(wrong.data()), wrong.size() * sizeof(float)});
        }
        stated["sparse"] = {
            {"count", which.size()},
            {"indices",
             {{"bufferView", file.view({reinterpret_cast<const char*>(which.data()), which.size()})},
              {"componentType", 5121}}},
            {"values",
             {{"bufferView",
               file.view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)})}}}};
        expectSquare(squareBy(file, file.accessor(stated)));
    }
}

TEST(GltfAccessors, ManyPrimitivesMayShareOne) {
    GltfBuilder file;
    std::vector<float> positions;
    for (int i = 0; i < 1000; ++i)
        positions.insert(positions.end(), {static_cast<float>(i % 10), static_cast<float>(i / 10), 0});
    const int shared = file.accessor(positions, "VEC3");
    const int colours = file.accessor(std::vector<std::uint8_t>(4000, 51), "VEC4", true);
    Json primitives = Json::array();
    for (std::uint32_t i = 0; i < 200; ++i) {
        const std::vector<std::uint32_t> corners{i, i + 1, i + 10};
        primitives.push_back({{"attributes", {{"POSITION", shared}, {"COLOR_0", colours}}},
                              {"indices", file.accessor(corners, "SCALAR")}});
    }
    file.node({{"mesh", file.mesh(primitives)}});
    const FileImport read = file.import();
    const Mesh mesh = meshOf(read.model);
    ASSERT_EQ(mesh.triangles.size(), 200U);
    EXPECT_EQ(mesh.position(0, 2), (Vec3{0, 1, 0}));
    EXPECT_EQ(mesh.colours[mesh.shading[0].v[0]], (Colour{0.2F, 0.2F, 0.2F}));
}

TEST(GltfAccessors, ThatLeadAstrayAreRefused) {
    const Json sound{{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}};
    struct Change {
        const char* name;
        Json value;
    };
    const Change changes[] = {{"count", 5},
                              {"count", 4294967295U},
                              {"count", 1e300},
                              {"count", -1},
                              {"count", "4"},
                              {"count", 1.5},
                              {"byteOffset", 4},
                              {"byteOffset", 9007199254740992U},
                              {"componentType", 5124},
                              {"componentType", 0},
                              {"type", "VEC5"},
                              {"bufferView", 77},
                              {"bufferView", -1},
                              {"sparse", {{"count", 5}}},
                              {"sparse", 1}};
    for (const Change& change : changes) {
        GltfBuilder file;
        Json stated = sound;
        stated["bufferView"] =
            file.view({reinterpret_cast<const char*>(test::kSquare.data()), 12 * sizeof(float)});
        stated[change.name] = change.value;
        const int positions = file.accessor(stated);
        const int corners = file.accessor(test::kSquareCorners, "SCALAR");
        file.show({{"attributes", {{"POSITION", positions}}}, {"indices", corners}});
        EXPECT_NE(test::refusalOf(file), "") << change.name << " " << change.value;
    }
}

TEST(GltfAccessors, ThatAreDamagedCostTheirOwnMesh) {
    GltfBuilder file = test::squareFile();
    const int broken =
        file.accessor(Json{{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}, {"bufferView", 99}});
    file.show({{"attributes", {{"POSITION", broken}}}});
    const FileImport read = file.import();
    expectSquare(read);
    EXPECT_NE(test::warningsOf(read).find("1 of its meshes are left out"), std::string::npos)
        << test::warningsOf(read);

    GltfBuilder colours = test::squareFile();
    colours.root["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 99;
    const FileImport plain = colours.import();
    expectSquare(plain);
    EXPECT_NE(test::warningsOf(plain).find("1 lists of normals, colours"), std::string::npos);
}

TEST(GltfAccessors, TexcoordsOfWholeNumbersLieAsThoseOfFloats) {
    GltfBuilder file = test::squareFile();
    Json& attributes = file.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] =
        file.accessor(std::vector<std::uint16_t>{0, 65535, 65535, 65535, 65535, 0, 0, 0}, "VEC2", true);
    const FileImport read = file.import();
    const Mesh mesh = meshOf(read.model);
    EXPECT_EQ(mesh.texcoords[mesh.shading[0].v[0]], (Vec2{0, 0}));
    EXPECT_EQ(mesh.texcoords[mesh.shading[0].v[2]], (Vec2{1, 1}));
}

} // namespace
