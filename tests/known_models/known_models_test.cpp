/// Up axis and unit of real models whose truth is known (models.txt). Those that are not in the repository
/// come from the folders that RT_TEST_SCENES and RT_KNOWN_MODELS name, else they are left out.
#include "rtcore/io/scene_loader.h"
#include "rtcore/scene/up_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct KnownModel {
    std::string where, file, up, truth;
    bool told = false;
    double height = 0;
};

std::vector<KnownModel> knownModels() {
    std::vector<KnownModel> all;
    std::ifstream list(fs::path(RT_SOURCE_FOLDER) / "tests/known_models/models.txt");
    for (std::string line; std::getline(list, line);) {
        if (line.empty() || line.starts_with("#")) continue;
        std::istringstream words(line);
        KnownModel model;
        std::string told;
        words >> model.where >> model.file >> told >> model.up >> model.height;
        std::getline(words >> std::ws, model.truth);
        model.told = told == "yes";
        all.push_back(model);
    }
    return all;
}

/// Nothing when it is not there.
std::optional<fs::path> pathOf(const KnownModel& model) {
    const char* const folder = model.where == "scenes" ? std::getenv("RT_TEST_SCENES")
                               : model.where == "made" ? std::getenv("RT_KNOWN_MODELS")
                                                       : RT_SOURCE_FOLDER "/data";
    if (folder == nullptr || !fs::exists(fs::path(folder) / model.file)) return std::nullopt;
    return fs::path(folder) / model.file;
}

rtcore::LoadedScene load(const fs::path& path) {
    rtcore::LoadOptions options;
    options.build.method = rtcore::BuildMethod::Fast;
    return rtcore::loadScene(path, options);
}

/// The model's height in metres, by the truth's up axis and the guess's unit.
double heightOf(const rtcore::LoadedScene& scene, rtcore::Vec3 up) {
    const double units = std::fabs(double{dot(scene.tree.bounds.size(), up)});
    return units * double{scene.units.metresPerUnit};
}

struct Count {
    int models = 0, missing = 0, up = 0, both = 0, told = 0, toldRight = 0;
};

void check(const KnownModel& model, const fs::path& path, Count& count) {
    const rtcore::LoadedScene scene = load(path);
    const rtcore::Vec3 up = rtcore::axisNamed(model.up).value();
    const double height = heightOf(scene, up);
    const bool rightUp = scene.units.up == up;
    const bool right = rightUp && std::fabs(std::log(height / model.height)) < std::log(1.5);
    ++count.models;
    count.up += rightUp ? 1 : 0;
    count.both += right ? 1 : 0;
    count.told += model.told ? 1 : 0;
    count.toldRight += model.told && right ? 1 : 0;
    std::printf("%s %-28s %s %8.4g m, true %s %8.4g m: %s\n", right ? "right" : "WRONG", model.file.c_str(),
                std::string(rtcore::axisName(scene.units.up)).c_str(), height, model.up.c_str(), model.height,
                rtcore::describe(scene.units).english().c_str());
}

TEST(KnownModels, TheListIsAsItWasMeant) {
    const std::vector<KnownModel> all = knownModels();
    EXPECT_EQ(all.size(), 45U);
    const auto told = std::count_if(all.begin(), all.end(), [](const KnownModel& m) { return m.told; });
    EXPECT_LE(told, 10);
    for (const KnownModel& model : all) {
        EXPECT_TRUE(rtcore::axisNamed(model.up)) << model.file;
        EXPECT_GT(model.height, 0) << model.file;
        EXPECT_FALSE(model.truth.empty()) << model.file;
    }
}

TEST(KnownModels, MostAreGuessedRight) {
    Count count;
    for (const KnownModel& model : knownModels()) {
        if (const auto path = pathOf(model)) {
            check(model, *path, count);
        } else {
            ++count.missing;
        }
    }
    std::printf("%d of %d are right, %d up axes; %d of the list are not there\n", count.both, count.models,
                count.up, count.missing);
    EXPECT_EQ(count.toldRight, count.told);
    // 40 of 45; of a part of the list the same share.
    EXPECT_GE(45 * count.both, 40 * count.models);
}

} // namespace
