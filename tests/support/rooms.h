/// Rooms and objects that looks are tried on.
#pragma once

#include "support/small_scene.h"

namespace test {

/// 12 x 4 x 8 around the origin; its walls face inwards. `open`: without its ceiling.
inline SceneBuilder room(bool open = false) {
    SceneBuilder b;
    const std::uint32_t white = b.material(matte(0.7F));
    const auto wall = [&](rtcore::Vec3 a, rtcore::Vec3 c, rtcore::Vec3 d, rtcore::Vec3 e) {
        b.quad(a, c, d, e, white);
    };
    wall({-6, -2, 4}, {6, -2, 4}, {6, -2, -4}, {-6, -2, -4});
    if (!open) wall({-6, 2, -4}, {6, 2, -4}, {6, 2, 4}, {-6, 2, 4});
    wall({-6, -2, -4}, {6, -2, -4}, {6, 2, -4}, {-6, 2, -4});
    wall({6, -2, 4}, {-6, -2, 4}, {-6, 2, 4}, {6, 2, 4});
    wall({-6, -2, 4}, {-6, -2, -4}, {-6, 2, -4}, {-6, 2, 4});
    wall({6, -2, -4}, {6, -2, 4}, {6, 2, 4}, {6, 2, -4});
    return b;
}

inline SceneBuilder block() {
    SceneBuilder b;
    b.box({-1, -1, -1}, {1, 1, 1}, b.material(matte(0.7F)));
    return b;
}

} // namespace test
