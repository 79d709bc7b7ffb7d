/// The file of views, and what is made without one.
#include "bench/rtbench/bench_view.h"

#include "rtcore/accel/builder.h"
#include "rtcore/platform/error.h"
#include "support/sample_meshes.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace {

class Views : public testing::Test {
  protected:
    rtbench::ViewFile read(const std::string& text) const {
        std::ofstream(folder / "v.toml") << text;
        return rtbench::ViewFile(folder / "v.toml");
    }
    std::string errorOf(const std::string& text) const {
        try {
            read(text);
        } catch (const rtcore::FileError& error) {
            EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
            return error.what();
        }
        return "no error";
    }

    test::TemporaryFolder folder;
};

const std::string kView = "[[view]]\nscene = \"nave.ply\"\neye = [1.0, 2.0, 3.0]\nat = [1.0, 2.0, -7.0]\n"
                          "light = [0.0, 9.0, 0.0]\n";

TEST_F(Views, BelongToModelsOfTheName) {
    const rtbench::ViewFile file =
        read("version = 1\n" + kView + "name = \"altar\"\nfov = 90.0\n" + kView + "name = \"rose\"\n");
    for (const char* model : {"nave.ply", "/somewhere/nave.bsp", "nave"}) {
        const auto views = file.viewsOf(model);
        ASSERT_EQ(views.size(), 2U) << model;
        EXPECT_EQ(views[0].name, "altar");
        EXPECT_EQ(views[1].name, "rose");
        EXPECT_EQ(views[0].light, (rtcore::Vec3{0, 9, 0}));
    }
    EXPECT_TRUE(file.viewsOf("nave2.ply").empty());
}

TEST_F(Views, FieldsOfViewAreVertical) {
    const rtbench::BenchView view = read("version = 1\n" + kView + "fov = 90.0\n").viewsOf("nave")[0];
    EXPECT_NEAR(view.camera(1).horizontalFov, 90, 1e-3);
    EXPECT_NEAR(view.camera(2).horizontalFov, 126.8699, 1e-3); // 2 atan(2)
    EXPECT_EQ(view.camera(1).forward, (rtcore::Vec3{0, 0, -10}));
}

TEST_F(Views, RefuseWhatMakesNoSense) {
    EXPECT_NE(errorOf("version = 1\n[[view]]\nscene = \"a\"\n").find("eye"), std::string::npos);
    EXPECT_NE(errorOf(kView).find("version"), std::string::npos);
    EXPECT_NE(errorOf("version = 1\n" + kView + "colour = 3\n").find("colour"), std::string::npos);
    EXPECT_NE(errorOf("version = 1\n" + kView + "fov = 180.0\n").find("fov"), std::string::npos);
    EXPECT_NE(errorOf("version = 1\n" + kView + "up = [0.0, 0.0, 1.0]\n").find("above"), std::string::npos);
}

TEST(MadeViews, ShowAnObject) {
    const test::SampleMesh sphere = test::icosphere(3);
    rtcore::LoadedScene loaded;
    loaded.scene.model.mesh = sphere.view();
    loaded.tree = rtcore::buildKdTree(sphere.view(), {});
    const rtbench::BenchView view = rtbench::makeView(loaded);
    EXPECT_GT(rtcore::length(view.eye), 1.5F);
    EXPECT_LT(dot(normalize(view.at - view.eye), normalize(view.eye)), -0.99F);
    EXPECT_GT(rtcore::length(view.light), 1.5F);
}

} // namespace
