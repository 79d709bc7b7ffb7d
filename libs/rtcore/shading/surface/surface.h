/// The surface at a ray's hit, ready to be lit.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/media_list.h"
#include "rtcore/scene/scene.h"

namespace rtcore {

struct Surface {
    Vec3 position;
    float clearance = 0;  ///< rays that leave start so far off `position`, on the side that they leave to
    Vec3 geometricNormal; ///< unit, on the side of the viewer
    Vec3 shadingNormal;   ///< unit, interpolated, turned to the viewer's side as the face is: where a file's
                          ///< normals are flatter than the face it may lie below it
    Vec3 toViewer;        ///< unit
    Colour diffuse;       ///< albedo with texture and vertex colour
    Colour emission;      ///< radiance
    float opacity = 1;    ///< of the material, with texture
    Colour specularTint{1, 1, 1}; ///< factor on the material's specular and mirror colours
    float coverage = 1;           ///< under 1 where an alpha lets rays pass as if nothing were there
    bool fromInside = false;      ///< the viewer is behind the front side
    bool closed = false;          ///< the surface bounds a solid, in which light is bent or tinted
    bool facet = false;           ///< the shading normal is that of one facet (frosted_glass.h)
    const Material* material = nullptr;
    float index = 1.5F;               ///< of refraction, of what lies behind it over that of what lies before
    const Material* behind = nullptr; ///< the solid that a ray comes into which passes it; null: air
    MediaList media;                  ///< that such a ray is in, where solids may overlap
};

/// `direction` is the ray's, of unit length. Safe from many threads, as are all of these.
Surface surfaceAt(const Scene& scene, bool textures, Vec3 direction, const Hit& hit);

/// Its shape and material alone, as if nothing were textured: all but what addMaterial() adds. Its clearance
/// is at least `clearance`, that of HitWave.
Surface shapeAt(const Scene& scene, Vec3 direction, const Hit& hit, float clearance = 0);
/// Adds the rest to such a surface. `turned`: its shading normal is minus the interpolated one.
void addMaterial(const Scene& scene, bool textures, const Hit& hit, bool turned, Surface& surface);

/// Completes a surface with its medium, as if it lay in air.
void setOwnMedium(const Scene& scene, std::uint32_t triangle, Surface& surface);
/// Completes a surface with what lies on both sides of it, and `closed`; a ray came from `media` to it. False
/// where there is nothing to be seen of it: a solid of a higher priority lies around, or the same medium on
/// both sides.
bool setMedia(const Scene& scene, std::uint32_t triangle, MediaList media, Surface& surface);

/// The albedo alone, with vertex colour, but without texture.
Colour untexturedAt(const Scene& scene, const Hit& hit);
/// The albedo alone, with texture and vertex colour.
Colour diffuseAt(const Scene& scene, bool textures, const Hit& hit);

/// Factors of roughness and metal in the material's texture of them.
struct RoughnessFactors {
    float roughness, metallic;
};
/// The factors at a hit of a material that has such a texture.
RoughnessFactors roughnessAt(const Scene& scene, const Hit& hit);

/// Only what a ray towards an emitter needs to know: the radiance given off, as far as no hole is there.
Colour emissionAt(const Scene& scene, bool textures, const Hit& hit);
/// Only what a shadow ray needs to know: how much of it an alpha lets meet the surface, from this side.
float coverageAt(const Scene& scene, bool textures, const Hit& hit, bool fromInside);
/// Fraction of the arriving light that does not pass the surface.
float opacityAt(const Scene& scene, bool textures, const Hit& hit);

} // namespace rtcore
