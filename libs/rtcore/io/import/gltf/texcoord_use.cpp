#include "rtcore/io/import/gltf/texcoord_use.h"

#include "rtcore/simd/portable_math.h"

namespace rtcore::gltf {

TexcoordUse texcoordUseOf(const Json& texture) {
    const Json& transform = extension(texture, "KHR_texture_transform");
    TexcoordUse use;
    use.set = wholeNumber(texture, "texCoord", 0);
    use.set = wholeNumber(transform, "texCoord", use.set);
    if (const auto offset = numbers<2>(transform, "offset")) use.offset = {(*offset)[0], (*offset)[1]};
    if (const auto scale = numbers<2>(transform, "scale")) use.scale = {(*scale)[0], (*scale)[1]};
    use.rotation = number(transform, "rotation", 0);
    return use;
}

TexcoordTransform::TexcoordTransform(const TexcoordUse& use)
    : use_(use), sine_(portableSin(use.rotation)), cosine_(portableCos(use.rotation)) {}

Vec2 TexcoordTransform::operator()(Vec2 t) const {
    const Vec2 offset = use_.offset, scale = use_.scale;
    // Rounded as Assimp's coordinates were, so that models keep their bits.
    if (use_.rotation == 0) return {t.x * scale.x + offset.x, (1 - t.y) * scale.y + (1 - scale.y - offset.y)};
    const float x = t.x * scale.x, y = t.y * scale.y;
    return {cosine_ * x + sine_ * y + offset.x, 1 - (cosine_ * y - sine_ * x + offset.y)};
}

} // namespace rtcore::gltf
