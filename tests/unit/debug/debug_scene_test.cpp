// The drawing of what the renderer works with, read back as the lines of its file.
#include "rtcore/io/debug/debug_scene.h"

#include "rtcore/render/camera_rays.h"
#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace rtcore {
namespace {

struct Drawn {
    std::vector<Vec3> points; ///< of the object's faces
    Box3 bounds() const {
        Box3 box;
        for (const Vec3 p : points) box.extend(p);
        return box;
    }
};

/// The faces of each object; fails where one names a vertex that is not there.
std::map<std::string, Drawn> read(const std::string& obj) {
    std::map<std::string, Drawn> objects;
    std::vector<Vec3> vertices;
    std::istringstream lines(obj);
    std::string line, name;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string key;
        words >> key;
        if (key == "o") words >> name, objects[name];
        if (key == "v") {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            vertices.push_back(p);
        }
        for (std::size_t i = 0; key == "f" && words >> i;) objects[name].points.push_back(vertices.at(i - 1));
    }
    return objects;
}

class DebugDrawing : public testing::Test {
  protected:
    static Scene scene() {
        test::SceneBuilder b;
        const std::uint32_t material = b.material(test::matte(0.5F));
        b.square({}, {0, 1, 0}, 5, material);
        b.sphere({1, 1, 0}, 1, 12, material);
        b.scene.lights.push_back(test::pointLight({2, 6, 3}, 10));
        b.scene.lights.push_back(test::pointLight({-3, 4, 1}, 10));
        b.scene.lights.back().light.on = 0;
        return b.finish();
    }
    DebugDrawing() {
        camera_.eye = {0, 2, 6};
        camera_.forward = {0, -0.3F, -1};
        drawing_ = sketchScene(traced_.scene, traced_.tree, traced_.tracer, camera_, 320, 200, "a.mtl");
        objects_ = read(drawing_.obj);
    }

    test::TracedScene traced_{scene()};
    Camera camera_;
    DebugScene drawing_;
    std::map<std::string, Drawn> objects_;
};

void expectNear(const Box3& a, const Box3& b, float tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(a.lo[axis], b.lo[axis], tolerance);
        EXPECT_NEAR(a.hi[axis], b.hi[axis], tolerance);
    }
}

TEST_F(DebugDrawing, ShowsTheTreeByDepth) {
    expectNear(objects_.at("tree_depth_00").bounds(), traced_.tree.bounds, 0.02F);
    const KdNode root = traced_.tree.nodes[0];
    ASSERT_FALSE(root.isLeaf());
    constexpr std::size_t pointsOfABox = 12 * (3 * 4 + 2 * 3);
    EXPECT_EQ(objects_.at("tree_depth_00").points.size(), pointsOfABox);
    EXPECT_EQ(objects_.at("tree_depth_01").points.size(), 2 * pointsOfABox);
    bool split = false;
    for (const Vec3 p : objects_.at("tree_depth_01").points)
        split = split || std::fabs(p[root.axis()] - root.split) < 0.02F;
    EXPECT_TRUE(split);
    EXPECT_GT(objects_.at("tree_heaviest_leaves").points.size(), pointsOfABox);
}

TEST_F(DebugDrawing, ShowsLightsWhereTheyAre) {
    EXPECT_LT(length(objects_.at("lights_on").bounds().centre() - Vec3{2, 6, 3}), 1e-4F);
    EXPECT_LT(length(objects_.at("lights_off").bounds().centre() - Vec3{-3, 4, 1}), 1e-4F);
}

TEST_F(DebugDrawing, ShowsWhatTheCameraSees) {
    const CameraRays rays(camera_, 320, 200);
    const Box3 bounds = objects_.at("camera").bounds();
    for (const float x : {0.0F, 320.0F}) {
        const Vec3 direction = rays.at(x, 0).direction;
        bool found = false; // a corner of the frustum along this ray
        for (const Vec3 p : objects_.at("camera").points) {
            const Vec3 way = p - rays.eye();
            found = found || (length(way) > 1 && dot(way, direction) > 0.9999F * length(way));
        }
        EXPECT_TRUE(found) << x;
    }
    EXPECT_LE(bounds.lo.z, 3);
    EXPECT_NEAR(bounds.hi.z, 6, 0.02);
}

TEST_F(DebugDrawing, PinsStandOnWhatRaysHit) {
    const Drawn& pins = objects_.at("normals_geometric");
    ASSERT_GT(pins.points.size(), 1000U);
    for (const Vec3 p : pins.points) {
        EXPECT_GT(p.y, -0.02F);
        if (length(p - Vec3{1, 1, 0}) > 1.2F) {
            EXPECT_LT(p.y, 0.25F);
        }
    }
    EXPECT_EQ(objects_.at("normals_shading").points.size(), pins.points.size());
}

TEST_F(DebugDrawing, HasAMaterialForEachObject) {
    EXPECT_TRUE(drawing_.obj.starts_with("mtllib a.mtl\n"));
    for (const auto& [name, drawn] : objects_)
        EXPECT_NE(drawing_.mtl.find("newmtl " + name + "\n"), std::string::npos) << name;
}

TEST(DebugScene, OfAnEmptySceneShowsTheCamera) {
    const test::TracedScene s{test::SceneBuilder().finish()};
    const auto objects = read(sketchScene(s.scene, s.tree, s.tracer, {}, 4, 3, "a.mtl").obj);
    EXPECT_FALSE(objects.at("camera").points.empty());
    EXPECT_TRUE(objects.at("normals_shading").points.empty());
}

} // namespace
} // namespace rtcore
