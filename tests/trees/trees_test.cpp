// The bits of images do not depend on the tree: the exact one and fast ones of several qualities, with
// every effect on. RT_TREE_CAMERAS sets from how many places each scene is looked at (3 unless told; 50 in
// the long check). With it, real scenes join the rooms of slats: our own, and those of the folder
// RT_TEST_SCENES.
#include "support/every_effect.h"
#include "trees/compared_pictures.h"
#include "trees/effects_scene.h"
#include "trees/slat_room.h"
#include "trees/viewpoints.h"
#include "trees/witness_tracer.h"

#include "rtcore/accel/builder.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using rtcore::RenderSettings;

constexpr int kQualities[] = {1, 5, 10};

/// 0 when RT_TREE_CAMERAS is not set.
int wantedCameras() {
    const char* const text = std::getenv("RT_TREE_CAMERAS");
    return text != nullptr ? std::max(std::atoi(text), 0) : 0;
}

/// Smaller images in every run.
RenderSettings pictureSettings() {
    return wantedCameras() > 0 ? test::everyEffect(160, 120) : test::everyEffect(112, 84);
}

struct Place {
    const char* name;
    const char* file;           ///< in data/ or in the folder of real scenes; "": a room of slats
    bool ours;                  ///< in data/
    test::SlatRoomOptions room; ///< where there is no file
    friend std::ostream& operator<<(std::ostream& out, const Place& place) { return out << place.name; }
};

const Place kPlaces[] = {
    {"slats", "", true, {.corner = {-906.604F, 400, -1020}}},
    {"farSlats", "", true, {.corner = {10'000, 400, -10'000}, .length = 5760, .seed = 2}},
    {"nave", "nave/nave.scn", true, {}},
    {"mirrors", "mirrors/mirrors.scn", true, {}},
    {"sibenik", "sibenik/sibenik.obj", false, {}},
    {"sponza", "sponza_crytek/sponza.obj", false, {}},
    {"dragon", "dragon/dragon.ply", false, {}},
    {"lamborghini", "lamborghini/lamborghini.glb", false, {}},
};

/// A tree, and what traces rays by it.
struct Traced {
    Traced(const rtcore::Mesh& mesh, const rtcore::BuildOptions& options)
        : tree(buildKdTree(mesh, options)), tracer(tree, mesh) {}
    rtcore::KdTree tree;
    rtcore::KdRayTracer tracer;
};

/// Sums over all cameras of a scene.
struct Totals {
    int pictures = 0, differingPictures = 0; ///< by fast trees
    std::size_t pixels = 0, differingPixels = 0;
    double covered = 0;         ///< fractions of the exact tree's images
    rtcore::RayStatistics rays; ///< of the exact tree
};

class Trees : public testing::TestWithParam<Place> {
  protected:
    void SetUp() override {
        rtcore::useInstructionSetOfEnvironment();
        const Place& place = GetParam();
        if (*place.file == 0) {
            scene_ = test::SlatRoom(place.room).build();
        } else {
            if (wantedCameras() == 0) GTEST_SKIP() << "RT_TREE_CAMERAS is not set";
            const char* const scenes = std::getenv("RT_TEST_SCENES");
            if (!place.ours && scenes == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
            const fs::path file =
                (place.ours ? fs::path(RT_SOURCE_FOLDER) / "data" : fs::path(scenes)) / place.file;
            rtcore::LoadOptions quick;
            quick.build.method = rtcore::BuildMethod::Fast;
            scene_ = rtcore::loadScene(file, quick).scene;
        }
        test::addEveryEffect(scene_);
    }

    test::Viewpoints viewpoints(const Traced& traced) const {
        return {traced.tree, scene_.mesh(), scene_.up, 1};
    }
    test::Picture picture(const rtcore::RayTracer& tracer, const rtcore::Camera& camera,
                          const RenderSettings& settings) const {
        return test::pictureOf(scene_, tracer, camera, settings);
    }

    static int cameras() { return std::max(wantedCameras(), 3); }

    /// Images by all trees. Prints where they differ, and by which rays.
    void compare(const Traced& exact, const std::deque<Traced>& fast, const rtcore::Camera& camera,
                 int number, Totals& totals) const {
        constexpr std::size_t kShown = 3;
        RenderSettings settings = pictureSettings();
        settings.skyLight = {.on = number % 2 == 1, .samples = 5}; // in place of ambient occlusion
        const test::Picture expected = picture(exact.tracer, camera, settings);
        totals.covered += test::coveredFraction(expected.frame);
        totals.rays.add(expected.frame.statistics);
        for (std::size_t k = 0; k < fast.size(); ++k) {
            const test::Picture found = picture(fast[k].tracer, camera, settings);
            const std::vector<std::size_t> wrong = test::differingPixels(expected.frame, found.frame);
            ++totals.pictures;
            totals.pixels += expected.frame.covered.size();
            totals.differingPixels += wrong.size();
            if (wrong.empty() && expected.developed.pixels == found.developed.pixels) continue;
            ++totals.differingPictures;
            std::printf("%s, camera %d, quality %d: %zu pixels differ\n", GetParam().name, number,
                        kQualities[k], wrong.size());
            for (std::size_t i = 0; i < std::min(wrong.size(), kShown); ++i)
                std::printf("  %s\n",
                            test::describeDifference(expected.frame, found.frame, wrong[i]).c_str());
            picture(test::WitnessTracer(exact.tracer, fast[k].tracer, kShown), camera, settings);
        }
    }

    rtcore::Scene scene_;
};

/// Says how far a scene is and what time it has left, no more than every ten seconds.
class Progress {
  public:
    Progress(const char* name, int all) : name_(name), all_(all) {}
    void tell(int done) {
        const double now = seconds();
        if (now - told_ < 10 || done == all_) return;
        told_ = now;
        std::fprintf(stderr, "%s: %d of %d cameras, %.0f s left\n", name_, done, all_,
                     now / done * (all_ - done));
    }
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    const char* name_;
    int all_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double told_ = 0;
};

std::string nameOf(const testing::TestParamInfo<Place>& place) { return place.param.name; }

} // namespace

TEST_P(Trees, PicturesHaveTheSameBits) {
    using rtcore::BuildMethod, rtcore::RayKind;
    const Traced exact(scene_.mesh(), {.method = BuildMethod::Exact});
    std::deque<Traced> fast;
    for (const int quality : kQualities)
        fast.emplace_back(scene_.mesh(),
                          rtcore::BuildOptions{.method = BuildMethod::Fast, .fastQuality = quality});
    test::Viewpoints views = viewpoints(exact);
    Progress progress(GetParam().name, cameras());
    Totals totals;
    for (int i = 0; i < cameras(); ++i) {
        compare(exact, fast, views.next(), i, totals);
        progress.tell(i + 1);
    }
    const double covered = totals.covered / cameras();
    std::printf("%s: %d images, %d differ; %zu pixels, %zu differ; %.0f %% show surfaces; %.0f million rays "
                "in each tree; %.0f s\n",
                GetParam().name, totals.pictures, totals.differingPictures, totals.pixels,
                totals.differingPixels, 100 * covered, static_cast<double>(totals.rays.total()) * 1e-6,
                progress.seconds());
    EXPECT_EQ(totals.differingPictures, 0);
    EXPECT_GT(covered, 0.5);
    for (const RayKind kind : {RayKind::Shadow, RayKind::Mirror, RayKind::Refracted, RayKind::Occlusion})
        EXPECT_GT(totals.rays.rays[static_cast<std::size_t>(kind)], totals.rays.total() / 1000)
            << static_cast<int>(kind);
}

TEST_P(Trees, EveryEffectShows) {
    const Traced traced(scene_.mesh(), {.method = rtcore::BuildMethod::Fast});
    const RenderSettings all = test::everyEffect(80, 60);
    const rtcore::Camera camera = viewpoints(traced).next();
    const test::Picture expected = picture(traced.tracer, camera, all);
    for (const test::WithoutEffect& without : test::withoutEachEffect(all)) {
        if (without.setting == "textures" && scene_.model.textures.empty()) continue;
        EXPECT_NE(expected.developed.pixels,
                  picture(traced.tracer, camera, without.settings).developed.pixels)
            << without.setting;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Trees, testing::ValuesIn(kPlaces), nameOf);
