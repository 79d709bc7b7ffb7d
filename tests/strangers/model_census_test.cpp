/// Models of the package assimp-testmodels, as the importer reads them, beside a list that is kept: none
/// changes unnoticed. Where blender_plain.py wrote how Blender reads them, both cover the same.
#include "rtcore/io/scene_loader.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/survey/closest_hit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using rtcore::Vec3;

const fs::path kModels = "/usr/share/assimp/models";
const fs::path kList = fs::path(RT_SOURCE_FOLDER) / "tests/strangers/model_census.txt";

/// Endings of files that are no models: images, buffers, shaders, texts.
bool isModel(const fs::path& path) {
    static const std::set<std::string> kOthers{".png", ".bin",  ".txt", ".jpg",  ".mtl",  ".glsl",
                                               ".tga", ".raw",  ".bmp", ".vert", ".frag", ".material",
                                               ".md",  ".skin", ".pk3", ".gz",   ".dds",  ".jpeg"};
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return !ending.empty() && !kOthers.contains(ending);
}

std::vector<std::string> modelNames() {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(kModels))
        if (entry.is_regular_file() && isModel(entry.path()))
            names.push_back(fs::relative(entry.path(), kModels).generic_string());
    std::ranges::sort(names);
    return names;
}

rtcore::LoadedScene load(const fs::path& path) {
    rtcore::LoadOptions options;
    options.build.method = rtcore::BuildMethod::Fast;
    options.import.memoryLimit = std::uint64_t{2} << 30; // sentences name it
    return rtcore::loadScene(path, options);
}

/// Triangles count alike: textures and light apart.
rtcore::Colour meanColour(const rtcore::Model& model) {
    rtcore::Colour sum;
    for (const rtcore::ShadingTriangle& triangle : model.mesh.shading)
        sum += model.materials[triangle.material].diffuse;
    const auto count = static_cast<float>(std::max<std::size_t>(model.mesh.shading.size(), 1));
    return sum * (1 / count);
}

std::string factsOf(const rtcore::LoadedScene& loaded) {
    const rtcore::Model& model = loaded.scene.model;
    const auto bounds = model.mesh.bounds();
    const Vec3 size = bounds.hi - bounds.lo;
    const rtcore::Colour colour = meanColour(model);
    return fmt::format(
        "{} parts, {} triangles, {:.4g} x {:.4g} x {:.4g}, colour {:.2f} {:.2f} {:.2f}, {} warnings",
        model.parts.size(), model.mesh.triangles.size(), size.x, size.y, size.z, colour.r, colour.g, colour.b,
        loaded.warnings.size());
}

/// Without the folders of this machine.
std::string withoutFolder(std::string text) {
    const std::string folder = kModels.string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
        text.erase(at, folder.size());
    std::ranges::replace(text, '\n', ' ');
    return text;
}

using Facts = std::map<std::string, std::string>;

Facts keptFacts() {
    Facts facts;
    std::ifstream list(kList);
    for (std::string line; std::getline(list, line);) {
        const std::size_t colon = line.find(": ");
        if (!line.starts_with("#") && colon != std::string::npos)
            facts[line.substr(0, colon)] = line.substr(colon + 2);
    }
    return facts;
}

void keep(const Facts& facts) {
    std::ofstream list(kList);
    list
        << "# What the importer makes of each model of the Debian package assimp-testmodels 5.2.5; of "
           "test_model_census,\n"
           "# which writes this file where RT_RENEW_CENSUS is set. A line that changes is to be looked at.\n";
    for (const auto& [name, fact] : facts) list << name << ": " << fact << '\n';
}

/// An axis and its sign.
struct Axis {
    int of = 0;
    float sign = 1;
};

/// Turns a model by quarters: 24 ways.
struct Turn {
    std::array<Axis, 3> axes;
    Vec3 operator()(Vec3 v) const {
        const std::array<float, 3> from{v.x, v.y, v.z};
        const auto of = [&](const Axis& axis) { return axis.sign * from[static_cast<std::size_t>(axis.of)]; };
        return {of(axes[0]), of(axes[1]), of(axes[2])};
    }
};

std::vector<Turn> allTurns() {
    std::vector<Turn> turns;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Turn turn;
            for (std::size_t i = 0; i < 3; ++i)
                turn.axes[i] = {order[i], (signs >> i & 1) != 0 ? -1.0F : 1.0F};
            const Vec3 x = turn({1, 0, 0}), y = turn({0, 1, 0}), z = turn({0, 0, 1});
            if (dot(cross(x, y), z) > 0) turns.push_back(turn);
        }
    } while (std::ranges::next_permutation(order).found);
    return turns;
}

/// Which squares of a grid the model covers along three axes, turned, fitted into a cube.
std::vector<bool> coverOf(const rtcore::LoadedScene& loaded, const Turn& turn) {
    constexpr int kSide = 48;
    const rtcore::Mesh& mesh = loaded.scene.model.mesh;
    const auto bounds = mesh.bounds();
    const Vec3 size = bounds.hi - bounds.lo, middle = (bounds.lo + bounds.hi) * 0.5F;
    const float half = 0.55F * std::max({size.x, size.y, size.z, 1e-30F});
    std::vector<bool> cover;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < kSide * kSide; ++i) {
            const float u = (static_cast<float>(i % kSide) + 0.5F) * (2.0F / kSide) - 1,
                        v = (static_cast<float>(i / kSide) + 0.5F) * (2.0F / kSide) - 1;
            const Vec3 at = axis == 0 ? Vec3{-2, u, v} : axis == 1 ? Vec3{u, -2, v} : Vec3{u, v, -2};
            const Vec3 along = axis == 0 ? Vec3{1, 0, 0} : axis == 1 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
            cover.push_back(
                rtcore::closestHit(loaded.tree, mesh, middle + turn(at) * half, turn(along)).has_value());
        }
    }
    return cover;
}

/// The agreement by the turn that suits best: up axes differ.
double agreement(const rtcore::LoadedScene& one, const rtcore::LoadedScene& other) {
    const std::vector<Turn> turns = allTurns();
    const std::vector<bool> mine = coverOf(one, {{Axis{0, 1}, Axis{1, 1}, Axis{2, 1}}});
    double best = 0;
    for (const Turn& turn : turns) {
        const std::vector<bool> theirs = coverOf(other, turn);
        double any = 0, both = 0;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            any += mine[i] || theirs[i] ? 1 : 0;
            both += mine[i] && theirs[i] ? 1 : 0;
        }
        best = std::max(best, any > 0 ? both / any : 1);
    }
    return best;
}

/// Models of which Blender shows something else, and why.
struct Known {
    const char* name;
    const char* why;
};
constexpr Known kKnown[] = {
    {"BLEND/BlenderDefault_262.blend", "Assimp does not find one of its blocks; refused"},
    {"BLEND/CubeHierarchy_248.blend", "Assimp loses three cubes of the hierarchy; there is a warning"},
    {"BLEND/MirroredCube_252.blend", "Assimp applies modifiers in part; there is a warning"},
    {"BLEND/SuzanneSubdiv_252.blend", "Assimp subdivides otherwise; there is a warning"},
    {"FBX/animation_with_skeleton.fbx", "Blender shows the first frame of its animation"},
    {"OBJ/box_UTF16BE.obj", "refused, with the remedy; Blender makes triangles without area of it"},
    {"OBJ/number_formats.obj", "its triangle has no area"},
};

class ModelCensus : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::exists(kModels)) GTEST_SKIP() << "assimp-testmodels is not installed";
    }

    static std::string factOf(const std::string& name) {
        try {
            return factsOf(load(kModels / name));
        } catch (const rtcore::FileError& error) {
            return "refused: " + withoutFolder(error.what());
        }
    }
};

/// All with RT_MODEL_CENSUS, else some.
TEST_F(ModelCensus, EachIsAsTheListSays) {
    const bool renews = std::getenv("RT_RENEW_CENSUS") != nullptr,
               all = renews || std::getenv("RT_MODEL_CENSUS") != nullptr;
    const Facts kept = keptFacts();
    Facts found;
    std::size_t number = 0;
    for (const std::string& name : modelNames()) {
        constexpr std::size_t kEach = 12;
        if (!all && number++ % kEach != 0) continue;
        found[name] = factOf(name);
        if (renews) continue;
        const auto entry = kept.find(name);
        ASSERT_NE(entry, kept.end()) << name << " is not in the list; it is: " << found[name];
        EXPECT_EQ(found[name], entry->second) << name;
    }
    if (renews) keep(found);
}

TEST_F(ModelCensus, CoversWhatBlenderShows) {
    const char* const folder = std::getenv("RT_CENSUS_PLAIN");
    if (folder == nullptr) GTEST_SKIP() << "RT_CENSUS_PLAIN is not set (blender_plain.py)";
    int compared = 0;
    for (const std::string& name : modelNames()) {
        const fs::path plain = fs::path(folder) / (name + ".ply");
        if (!fs::exists(plain)) continue;
        const auto known = std::ranges::find_if(kKnown, [&](const Known& each) { return name == each.name; });
        if (known != std::end(kKnown)) continue;
        SCOPED_TRACE(name);
        try {
            EXPECT_GE(agreement(load(kModels / name), load(plain)), 0.97);
            ++compared;
        } catch (const rtcore::FileError& error) {
            ADD_FAILURE() << error.what();
        }
    }
    EXPECT_GE(compared, 50);
}

} // namespace
