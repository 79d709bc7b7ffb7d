/// How a material lays an image on a surface.
#pragma once

#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/math/vec.h"

#include <cstdint>

namespace rtcore::gltf {

/// Which of a mesh's texture coordinates an image uses, and how it transforms them (KHR_texture_transform).
struct TexcoordUse {
    std::uint64_t set = 0;
    Vec2 offset, scale{1, 1};
    float rotation = 0; ///< radians

    friend bool operator==(const TexcoordUse&, const TexcoordUse&) = default;
};

/// `texture` names a texture, or is nothing.
TexcoordUse texcoordUseOf(const Json& texture);

/// From coordinates of files, (0, 0) = upper left of the image, to ours, (0, 0) = lower left.
class TexcoordTransform {
  public:
    explicit TexcoordTransform(const TexcoordUse& use);
    Vec2 operator()(Vec2 t) const;

  private:
    TexcoordUse use_;
    float sine_, cosine_;
};

} // namespace rtcore::gltf
