#include "rtcore/shading/point_materials.h"

#include "rtcore/shading/surface/texture_wave.h"

namespace rtcore {

Surface surfaceOfPoint(const FrameContext& frame, const Wave& wave, std::size_t i) {
    const SurfaceWave& surfaces = wave.surfaces;
    const Scene& scene = *frame.scene;
    const Hit hit = wave.hits.hit(i);
    Surface s;
    s.position = surfaces.position.at(i);
    s.clearance = surfaces.clearance[i];
    s.geometricNormal = surfaces.geometricNormal.at(i);
    s.shadingNormal = surfaces.shadingNormal.at(i);
    s.toViewer = surfaces.toViewer.at(i);
    s.fromInside = (surfaces.traits[i] & traits::kFromInside) != 0;
    s.material = &scene.material(surfaces.material[i]);
    setOwnMedium(scene, hit.triangle, s);
    const bool turned = (surfaces.traits[i] & traits::kTurned) != 0;
    addMaterial(scene, frame.settings->textures, hit, turned, s);
    return s;
}

void PointMaterials::lookUpAlbedos(const FrameContext& frame, const Wave& wave) {
    texturedAlbedos(*frame.scene, wave.hits, {point_, count_}, albedo_);
}

} // namespace rtcore
