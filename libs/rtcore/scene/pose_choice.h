/// The pose that an import gives to a model whose file animates it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

struct PoseChoice {
    enum class Kind : std::uint8_t {
        Rest,  ///< as the nodes of the file say
        First, ///< the first animation at its beginning
        Moment ///< `animation` at `seconds`
    };
    Kind kind = Kind::Rest;
    std::string animation; ///< its name, else its number, from 1
    double seconds = 0;    ///< finite; in the animation's own time, held at both of its ends
    friend bool operator==(const PoseChoice&, const PoseChoice&) = default;
};

/// "rest", "first" or "NAME@SECONDS", where the last @ counts; nothing for what is none of them.
std::optional<PoseChoice> readPose(std::string_view text);

/// What readPose() makes the same of.
std::string poseText(const PoseChoice& pose);

} // namespace rtcore
