// Light that is learned while one edits at random. RT_EDITS sets how many edits (check-long.sh: 10,000, under
// sanitizers).

#include "parted_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace rtcore {
namespace {

constexpr std::size_t kParts = 4;

/// A room with a wall across it, a box, a mirror and a box that shines, each of which is a part; two lights.
Scene editedRoom() {
    test::SceneBuilder b;
    const auto white = b.material(test::matte(0.7F)), grey = b.material(test::matte(0.4F)),
               mirrored = b.material(test::mirror(0.9F)), shining = b.material(test::emitter({3, 2, 1}));
    b.box({2, 0, 0}, {2.1F, 3, 4}, white);
    b.box({0.5F, 0, 1}, {1, 1, 2}, grey);
    b.box({3.5F, 0.5F, 1}, {3.52F, 2, 3}, mirrored);
    b.box({2.8F, 0, 2.5F}, {3.1F, 0.3F, 2.8F}, shining);
    for (std::uint32_t part = 0; part < kParts; ++part)
        b.buffers.parts.push_back({b.buffers.addName(std::to_string(part)), 12 * part, 12});
    test::addRoom(b, {0, 0, 0}, {4, 3, 4}, white);
    Scene scene = b.finish();
    scene.lights = {test::pointLight({1, 2.5F, 2}, 4), test::pointLight({3, 2.5F, 1}, 2)};
    return scene;
}

class RandomEdits {
  public:
    RandomEdits() { addReceivers(room); }

    void edit() {
        if (!before_.empty() && random_.index(5) == 0) {
            room.change(std::move(before_.back()));
            before_.pop_back();
            return;
        }
        before_.push_back(room.scene());
        room.change(edited(room.scene()));
    }
    /// Of the light that all receivers are shown: each is a number, and none is below 0.
    bool isSound() const {
        std::vector<ArrivingLight> arriving(room.receivers.size());
        room.light.cache().lookUp(room.receivers, arriving);
        for (const ArrivingLight& each : arriving) {
            const Colour light = each.irradiance;
            if (!isFinite(light) || !(light.r >= 0 && light.g >= 0 && light.b >= 0)) return false;
        }
        return true;
    }
    static void addReceivers(test::PartedScene& scene) {
        scene.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 150, 0.006F);
    }

    test::PartedScene room{editedRoom()};

  private:
    Scene edited(Scene scene) {
        Light& light = scene.lights[random_.index(2)].light;
        switch (random_.index(8)) {
        case 0:
            light.on = light.on != 0 ? 0 : 1;
            break;
        case 1:
            light.position = {random_.number(0.2F, 3.8F), random_.number(0.2F, 2.8F),
                              random_.number(0.2F, 3.8F)};
            break;
        case 2:
            scene.materials[random_.index(2)].diffuse = {random_.number(0, 1), random_.number(0, 1),
                                                         random_.number(0, 1)};
            break;
        case 3:
            scene.background = {random_.number(0, 1), 0.5F, 1};
            break;
        default:
            togglePart(scene);
        }
        return scene;
    }
    void togglePart(Scene& scene) {
        std::vector<std::uint8_t> hidden(kParts);
        if (scene.hiddenParts != nullptr) hidden = *scene.hiddenParts;
        const std::uint32_t part = random_.index(kParts);
        hidden[part] = hidden[part] != 0 ? 0 : 1;
        scene.hiddenParts = std::make_shared<const std::vector<std::uint8_t>>(std::move(hidden));
    }

    test::Random random_{161};
    std::vector<Scene> before_; ///< that undo goes back to
};

TEST(Edits, AtRandomEndInTheLightOfTheLastState) {
    const char* const wanted = std::getenv("RT_EDITS");
    const int edits = wanted != nullptr ? std::atoi(wanted) : 200;
    RandomEdits random;
    test::PartedScene& room = random.room;
    room.budget = {.rays = 1024, .paths = 128, .compared = 300}; // edits come while others are followed
    for (int i = 0; i < edits; ++i) {
        random.edit();
        if (i % 3 != 0) room.learn(i % 3, 150);
        ASSERT_TRUE(random.isSound()) << "after edit " << i;
        if (i % 64 != 0) continue;
        ASSERT_EQ(checkIndirectState(room.light.state()), std::nullopt) << "after edit " << i;
    }
    Scene last = room.scene();
    last.lights[0].light.on = 1; // something is to be seen
    room.change(std::move(last));
    test::PartedScene cold(editedRoom());
    cold.change(room.scene());
    RandomEdits::addReceivers(cold);
    for (test::PartedScene* const scene : {&room, &cold}) {
        scene->budget = {16384, 1536};
        scene->receivers = cold.receivers;
        scene->learn(60);
    }
    const std::vector<double> is = room.shown(), expected = cold.shown();
    double difference = 0, sum = 0, light = 0;
    for (std::size_t i = 0; i < is.size(); ++i) {
        difference += std::abs(is[i] - expected[i]);
        sum += is[i] - expected[i];
        light += expected[i];
    }
    EXPECT_LT(std::abs(sum / light), 0.02);
    EXPECT_LT(difference / light, 0.06);
}

} // namespace
} // namespace rtcore
