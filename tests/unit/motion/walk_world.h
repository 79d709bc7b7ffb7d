/// Rooms made of boxes and quads, in metres with z up, and a player in them.
#pragma once

#include "rtcore/accel/builder.h"
#include "rtcore/motion/player.h"
#include "rtcore/motion/walker.h"
#include "support/random_keys.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace test {

inline rtcore::Vec3 metres(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

inline rtcore::ActionSet only(rtcore::Action action) {
    rtcore::ActionSet actions;
    actions.set(action);
    return actions;
}

/// z up, x right, y ahead; so is the scene.
class WalkWorld {
  public:
    WalkWorld& quad(rtcore::Vec3 a, rtcore::Vec3 b, rtcore::Vec3 c, rtcore::Vec3 d) {
        mesh_.addTriangle(a, b, c);
        mesh_.addTriangle(a, c, d);
        return *this;
    }
    WalkWorld& floor(double z = 0, double half = 60) {
        return quad(metres(-half, -half, z), metres(half, -half, z), metres(half, half, z),
                    metres(-half, half, z));
    }
    WalkWorld& box(rtcore::Vec3 lo, rtcore::Vec3 hi) {
        SampleMesh cube = boxGrid(1);
        cube.map([=](rtcore::Vec3 p) {
            return rtcore::Vec3{p.x < 0 ? lo.x : hi.x, p.y < 0 ? lo.y : hi.y, p.z < 0 ? lo.z : hi.z};
        });
        return add(cube);
    }
    WalkWorld& add(const SampleMesh& mesh) {
        mesh_.append(mesh);
        return *this;
    }
    SampleMesh& mesh() { return mesh_; }

    const rtcore::KdTree& tree() {
        if (tree_.nodes.empty()) {
            rtcore::BuildOptions options;
            options.threads = 1;
            tree_ = rtcore::buildKdTree(mesh_.view(), options);
        }
        return tree_;
    }
    rtcore::Mesh view() const { return mesh_.view(); }

    /// A player of 1.80 m who walks 3 m/s and jumps 0.60 m.
    static rtcore::WalkShape shape() {
        rtcore::WalkParameters parameters;
        parameters.speed = 3;
        parameters.jumpHeight = 0.6F;
        return rtcore::WalkShape(parameters);
    }
    std::unique_ptr<rtcore::Walker> walker(double x, double y, double z) {
        auto walker =
            std::make_unique<rtcore::Walker>(tree(), view(), rtcore::WorldFrame({0, 0, 1}, 1), shape());
        EXPECT_TRUE(walker->enter({x, y, z + 1.7}));
        return walker;
    }
    std::unique_ptr<rtcore::Player> player(double x, double y, double z) {
        rtcore::PlayerOptions options;
        options.up = {0, 0, 1};
        options.metresPerUnit = 1;
        options.walk.speed = 3;
        options.walk.jumpHeight = 0.6F;
        auto player = std::make_unique<rtcore::Player>(tree(), view(), options);
        rtcore::Camera camera;
        camera.eye = metres(x, y, z + 1.7);
        camera.forward = {0, 1, 0};
        camera.up = {0, 0, 1};
        player->setCamera(camera);
        return player;
    }

  private:
    SampleMesh mesh_;
    rtcore::KdTree tree_;
};

/// Ahead is at `degrees` to the right of the y axis.
inline rtcore::WalkInput ahead(double degrees = 0) {
    const double a = degrees * 3.14159265358979323846 / 180;
    rtcore::WalkInput input;
    input.ahead = {std::sin(a), std::cos(a), 0};
    input.forward = 1;
    return input;
}

inline void walkFor(rtcore::Walker& walker, const rtcore::WalkInput& input, int ticks) {
    for (int i = 0; i < ticks; ++i) EXPECT_TRUE(walker.tick(input));
}
inline void stand(rtcore::Walker& walker, int ticks = 60) { walkFor(walker, {}, ticks); }

} // namespace test
