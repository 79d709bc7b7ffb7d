/// Buildings of several rooms, one part of which is hidden and shown: doors, a hatch, a shutter, an emitter.
#pragma once

#include "parted_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// What an edit of the part means for those who stand in a room.
enum class RoomKind { Lit, Beside, Elsewhere };

struct RoomSeen {
    RoomKind kind;
    rtcore::Vec3 eye;
};

struct Building {
    std::string name;
    rtcore::Scene scene; ///< its first part is the one that is hidden and shown
    std::vector<RoomSeen> rooms;
    /// Its light comes through an opening far off, which few paths find: the mean of those that do is noisy.
    bool dimOnceOpen = false;
    bool isUsual = false; ///< tested always, not in long checks alone
};

/// Adds a wall across x of a room from z = `z0` to `z1`, with a doorway from `from` to `to`.
inline void addWallWithDoor(SceneBuilder& b, float x, float z0, float z1, float from, float to, float height,
                            std::uint32_t material) {
    constexpr float kThick = 0.1F, kCeiling = 3;
    b.box({x, 0, z0}, {x + kThick, kCeiling, from}, material);
    b.box({x, 0, to}, {x + kThick, kCeiling, z1}, material);
    b.box({x, height, from}, {x + kThick, kCeiling, to}, material);
}

/// Three rooms in a row, of which the first and the last have lights; a door between the first two.
inline Building roomsWithADoor() {
    SceneBuilder b;
    const auto white = b.material(matte(0.7F)), grey = b.material(matte(0.4F));
    b.box({4.02F, 0, 1.5F}, {4.08F, 2.1F, 2.5F}, grey);
    b.buffers.parts = {{b.buffers.addName("door"), 0, 12}};
    addRoom(b, {0, 0, 0}, {12.2F, 3, 4}, white);
    addWallWithDoor(b, 4, 0, 4, 1.5F, 2.5F, 2.1F, white);
    b.box({8.1F, 0, 0}, {8.2F, 3, 4}, white);
    b.box({6.5F, 0, 0.5F}, {7.5F, 1, 1.5F}, grey);
    Building made{"door", b.finish(), {}, true, true};
    made.scene.lights = {pointLight({1, 2.5F, 2}, 10), pointLight({10, 2.5F, 2}, 3)};
    made.rooms = {{RoomKind::Lit, {2, 1.6F, 2}},
                  {RoomKind::Beside, {6, 1.6F, 2.2F}},
                  {RoomKind::Elsewhere, {10.2F, 1.6F, 2}}};
    return made;
}

/// A room round a corner, at which a door leads to a dark one; another one is lit by itself.
inline Building roomWithACorner() {
    SceneBuilder b;
    const auto white = b.material(matte(0.75F)), wood = b.material(matte(0.3F));
    b.box({2, 0, 3.02F}, {2.9F, 2, 3.06F}, wood);
    b.buffers.parts = {{b.buffers.addName("door"), 0, 12}};
    addRoom(b, {0, 0, 0}, {9, 2.8F, 7}, white);
    b.box({0, 0, 3}, {2, 2.8F, 3.1F}, white); // of the dark room, towards the corner
    b.box({2, 2, 3}, {2.9F, 2.8F, 3.1F}, white);
    b.box({2.9F, 0, 3}, {3, 2.8F, 7}, white);
    b.box({6, 0, 0}, {6.2F, 2.8F, 7}, white);
    b.box({0.3F, 0, 5}, {1.3F, 0.8F, 6.8F}, wood);
    b.box({4, 0, 0.2F}, {5.5F, 0.9F, 0.8F}, wood);
    Building made{"corner", b.finish(), {}, true};
    made.scene.lights = {pointLight({4.5F, 2.4F, 6}, 12), pointLight({7.5F, 2.4F, 3}, 4)};
    made.rooms = {{RoomKind::Lit, {2.5F, 1.6F, 1.5F}},
                  {RoomKind::Beside, {1.5F, 1.6F, 4.5F}},
                  {RoomKind::Elsewhere, {7.5F, 1.6F, 3.5F}}};
    return made;
}

/// Two storeys with a hatch between them; upstairs one room is dark, another lit.
inline Building twoStoreys() {
    SceneBuilder b;
    const auto white = b.material(matte(0.7F)), wood = b.material(matte(0.45F));
    b.box({1.5F, 2.65F, 1.5F}, {2.5F, 2.75F, 2.5F}, wood);
    b.buffers.parts = {{b.buffers.addName("hatch"), 0, 12}};
    addRoom(b, {0, 0, 0}, {8, 5.4F, 4}, white);
    b.box({0, 2.6F, 0}, {1.5F, 2.8F, 4}, white); // the floor around the hatch
    b.box({2.5F, 2.6F, 0}, {8, 2.8F, 4}, white);
    b.box({1.5F, 2.6F, 0}, {2.5F, 2.8F, 1.5F}, white);
    b.box({1.5F, 2.6F, 2.5F}, {2.5F, 2.8F, 4}, white);
    b.box({4, 2.8F, 0}, {4.1F, 5.4F, 4}, white);
    Building made{"hatch", b.finish(), {}, true};
    made.scene.lights = {pointLight({5, 2.2F, 2}, 12), pointLight({6, 5, 2}, 3)};
    made.rooms = {{RoomKind::Lit, {3.5F, 1.6F, 2}},
                  {RoomKind::Beside, {3, 4.4F, 2}},
                  {RoomKind::Elsewhere, {6, 4.4F, 2}}};
    return made;
}

/// A cupboard in a lit room.
inline Building roomWithACupboard() {
    SceneBuilder b;
    const auto white = b.material(matte(0.7F)), wood = b.material(matte(0.5F));
    b.box({0.02F, 0.02F, 0.6F}, {1.18F, 1.98F, 0.62F}, wood);
    b.buffers.parts = {{b.buffers.addName("leaf"), 0, 12}};
    addRoom(b, {0, 0, 0}, {5, 2.7F, 4}, white);
    const auto board = [&](rtcore::Vec3 lo, rtcore::Vec3 hi) { b.box(lo, hi, wood); };
    board({0, 0, 0.02F}, {0.02F, 2, 0.62F});
    board({1.18F, 0, 0.02F}, {1.2F, 2, 0.62F});
    board({0, 0, 0}, {1.2F, 2, 0.02F});
    board({0.02F, 0, 0.02F}, {1.18F, 0.02F, 0.62F});
    board({0.02F, 1.98F, 0.02F}, {1.18F, 2, 0.62F});
    board({0.02F, 1, 0.02F}, {1.18F, 1.02F, 0.55F});
    Building made{"cupboard", b.finish(), {}, false, true};
    made.scene.lights = {pointLight({4, 2.4F, 3}, 8)};
    made.rooms = {{RoomKind::Lit, {2.5F, 1.6F, 2}}, {RoomKind::Beside, {0.6F, 1.5F, 0.5F}}};
    return made;
}

/// Three rooms in a row, of which the first is lit; its door is open, and the next one is the part.
inline Building rowOfRooms() {
    SceneBuilder b;
    const auto white = b.material(matte(0.7F)), grey = b.material(matte(0.4F));
    b.box({8.12F, 0, 0.5F}, {8.18F, 2.1F, 1.5F}, grey);
    b.buffers.parts = {{b.buffers.addName("door"), 0, 12}};
    addRoom(b, {0, 0, 0}, {12.2F, 3, 4}, white);
    addWallWithDoor(b, 4, 0, 4, 2, 3, 2.1F, white);
    addWallWithDoor(b, 8.1F, 0, 4, 0.5F, 1.5F, 2.1F, white);
    b.box({10, 0, 2.5F}, {11, 1, 3.5F}, grey);
    Building made{"row", b.finish(), {}, true};
    made.scene.lights = {pointLight({2, 2.5F, 1.5F}, 20)};
    made.rooms = {{RoomKind::Elsewhere, {2, 1.6F, 2}},
                  {RoomKind::Lit, {6, 1.6F, 2}},
                  {RoomKind::Beside, {10, 1.6F, 2}}};
    return made;
}

/// Two rooms with windows under a sky; the part is the shutter of one.
inline Building roomWithAShutter() {
    SceneBuilder b;
    const auto white = b.material(matte(0.7F)), grey = b.material(matte(0.4F));
    b.box({1.4F, 0.9F, -0.14F}, {2.6F, 2.1F, -0.1F}, grey);
    b.buffers.parts = {{b.buffers.addName("shutter"), 0, 12}};
    const auto wall = [&](rtcore::Vec3 lo, rtcore::Vec3 hi) { b.box(lo, hi, white); };
    wall({-0.1F, -0.1F, -0.1F}, {8.2F, 0, 4.1F});
    wall({-0.1F, 2.7F, -0.1F}, {8.2F, 2.8F, 4.1F});
    wall({-0.1F, 0, -0.1F}, {0, 2.7F, 4.1F});
    wall({8.1F, 0, -0.1F}, {8.2F, 2.7F, 4.1F});
    wall({4, 0, 0}, {4.1F, 2.7F, 4});
    wall({0, 0, 4}, {8.1F, 2.7F, 4.1F});
    for (const float x : {0.0F, 4.1F}) { // around each window
        wall({x, 0, -0.1F}, {x + 4, 0.9F, 0});
        wall({x, 2.1F, -0.1F}, {x + 4, 2.7F, 0});
        wall({x, 0.9F, -0.1F}, {x + 1.4F, 2.1F, 0});
        wall({x + 2.6F, 0.9F, -0.1F}, {x + 4.1F, 2.1F, 0});
    }
    b.box({0.3F, 0, 2.5F}, {1.3F, 0.8F, 3.5F}, grey);
    Building made{"shutter", b.finish(), {}};
    made.scene.background = {2, 3, 5};
    made.rooms = {{RoomKind::Beside, {2, 1.6F, 2.5F}}, {RoomKind::Elsewhere, {6.1F, 1.6F, 2.5F}}};
    return made;
}

/// Two rooms with an emitter each, of few triangles or of many, and a doorway to a third; the part is one.
inline Building roomsOfEmitters(std::uint32_t rings) {
    SceneBuilder b;
    const auto white = b.material(matte(0.7F)), shining = b.material(emitter({40, 36, 30}));
    const auto addEmitter = [&](rtcore::Vec3 at) {
        if (rings > 0)
            b.sphere(at, 0.15F, rings, shining);
        else
            b.box(at - rtcore::Vec3{0.12F, 0.12F, 0.12F}, at + rtcore::Vec3{0.12F, 0.12F, 0.12F}, shining);
    };
    addEmitter({2, 2.4F, 2});
    const auto triangles = static_cast<std::uint32_t>(b.buffers.triangles.size());
    b.buffers.parts = {{b.buffers.addName("emitter"), 0, triangles}};
    addEmitter({10, 2.4F, 2});
    addEmitter({3.3F, 0.5F, 3.3F}); // the room of the first one is not dark without it
    addRoom(b, {0, 0, 0}, {12.2F, 3, 4}, white);
    addWallWithDoor(b, 4, 0, 4, 1.5F, 2.5F, 2.1F, white);
    b.box({8.1F, 0, 0}, {8.2F, 3, 4}, white);
    Building made{rings > 0 ? "emitters" : "emitter", b.finish(), {}};
    made.rooms = {{RoomKind::Beside, {2, 1.6F, 2}},
                  {RoomKind::Lit, {6, 1.6F, 2}},
                  {RoomKind::Elsewhere, {10.2F, 1.6F, 2}}};
    return made;
}

/// Walks in all rooms at once, and shows their mean light.
class EditedBuilding {
  public:
    EditedBuilding(const Building& of, bool hidden)
        : parted(of.scene, std::vector<std::uint8_t>{static_cast<std::uint8_t>(hidden ? 1 : 0)}),
          rooms_(of.rooms) {
        look();
    }
    void hide(bool hidden) {
        parted.hide({static_cast<std::uint8_t>(hidden ? 1 : 0)});
        look();
    }
    /// Takes a scene of other lights or materials.
    void change(rtcore::Scene scene) {
        parted.change(std::move(scene));
        look();
    }
    /// What is seen from a room, in its order.
    std::vector<rtcore::Receiver> seen(std::size_t room, std::size_t count) const {
        Random random(room + 7);
        rtcore::RayWave rays;
        for (std::size_t i = 0; i < count; ++i)
            rays.push({rooms_[room].eye, 0, random.unitVector(), std::numeric_limits<float>::max()});
        rtcore::HitWave hits;
        parted.tracer().intersect(rtcore::RayKind::Primary, rays, hits);
        std::vector<rtcore::Receiver> found(count);
        for (std::size_t i = 0; i < count; ++i) {
            if (!hits.isHit(i)) continue;
            const rtcore::Hit hit = hits.hit(i);
            const rtcore::Ray ray = rays.ray(i);
            rtcore::Vec3 normal = rtcore::normalize(parted.scene().mesh().geometricNormal(hit.triangle));
            if (dot(normal, ray.direction) > 0) normal = normal * -1;
            found[i] =
                receiverAt(ray.origin + ray.direction * hit.t, normal, std::max(kPixel * hit.t, 0.001F));
        }
        return found;
    }
    std::size_t rooms() const { return rooms_.size(); }
    RoomKind kind(std::size_t room) const { return rooms_[room].kind; }

    PartedScene parted;
    static constexpr std::size_t kSeen = 3000; ///< points of a room

  private:
    static constexpr float kPixel = 0.0013F; ///< at 1 m

    void look() {
        parted.receivers.clear();
        for (std::size_t room = 0; room < rooms_.size(); ++room)
            for (const rtcore::Receiver& each : seen(room, kSeen))
                if (each.pixel > 0) parted.receivers.push_back(each);
    }

    std::vector<RoomSeen> rooms_;
};

/// Points that are seen in both states of a building, by room.
inline std::vector<std::vector<rtcore::Receiver>> seenInBoth(const EditedBuilding& a,
                                                             const EditedBuilding& b) {
    constexpr std::size_t kProbes = 1500;
    std::vector<std::vector<rtcore::Receiver>> both(a.rooms());
    for (std::size_t room = 0; room < a.rooms(); ++room) {
        const auto ofA = a.seen(room, kProbes), ofB = b.seen(room, kProbes);
        for (std::size_t i = 0; i < kProbes; ++i)
            if (ofA[i].pixel > 0 && ofA[i].position == ofB[i].position) both[room].push_back(ofA[i]);
    }
    return both;
}

} // namespace test
