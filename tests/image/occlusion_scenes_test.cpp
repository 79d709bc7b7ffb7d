// The patterns of ambient occlusion in real rooms (thesis figure 8.12).
#include "rtcore/io/scene_loader.h"
#include "support/occlusion_quality.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

void expectRotatedIsBest(const fs::path& path) {
    const rtcore::LoadedScene loaded = rtcore::loadScene(path);
    const rtcore::KdRayTracer tracer(loaded.tree, loaded.scene.mesh());
    test::OcclusionQuality(loaded.scene, tracer, loaded.camera).expectRotatedIsBest(path.stem().string());
}

TEST(OcclusionScenes, TheRotatedPatternIsBestInSibenik) {
    const char* const folder = std::getenv("RT_TEST_SCENES");
    if (folder == nullptr) GTEST_SKIP() << "skipped: RT_TEST_SCENES names no folder of models";
    expectRotatedIsBest(fs::path(folder) / "sibenik" / "sibenik.ply");
}

TEST(OcclusionScenes, TheRotatedPatternIsBestInTheNave) {
    const fs::path data = fs::path(RT_SOURCE_FOLDER) / "data";
    if (!fs::exists(data / "nave" / "generated" / "nave.glb") ||
        !fs::exists(data / "environments" / "generated" / "day.hdr")) {
        GTEST_SKIP() << "skipped: scripts/make_data.sh has not made the nave";
    }
    expectRotatedIsBest(data / "nave" / "nave.scn");
}

} // namespace
