/// A small room, what is learned of its light, and files of it.
#pragma once

#include "rtcore/io/light/light_bytes.h"
#include "rtcore/io/light/light_file.h"
#include "rtcore/platform/error.h"

#include "unit/gathering/gathering_support.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace test {

using Bytes = std::vector<std::byte>;

/// The light of the furnished room after some steps, of which few records and cells are left.
class LearnedRoom {
  public:
    explicit LearnedRoom(int steps, std::size_t receivers = 40) : room(furnishedRoom()) {
        room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, receivers, 0.02F);
        room.budget = {1024, 100};
        room.learn(steps, 60, 2);
    }
    rtcore::LightKey key() const { return keyOf(room.traced.scene); }
    rtcore::LightKey keyOf(const rtcore::Scene& scene) const {
        return rtcore::lightKeyOf(scene, room.traced.tracer.bounds(), room.settings);
    }
    Bytes bytes() const { return rtcore::lightBytes(key(), room.light.state()); }

    GatheringScene room;
};

/// The reason why bytes are refused; nothing where they are not.
inline std::optional<std::string> refusal(const Bytes& bytes, const rtcore::LightKey& key) {
    try {
        rtcore::readLightFile(bytes, key, "room.light");
    } catch (const rtcore::FileError& error) {
        return error.what();
    }
    return std::nullopt;
}

} // namespace test
