/// A scene with its lights and materials, as rays and paths that gather light need it.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/scene/part_list.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/fog/fog.h"
#include "rtcore/shading/surface/material_table.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rtcore {

/// Read by many threads, once it is prepared.
class LitScene {
  public:
    /// The scene and the tracer must live as long as they are used.
    void prepare(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);
    /// The same, but with emitters that shine in this state, or in one in which other parts are hidden: paths
    /// choose among the same ones in both, and those that do not shine are dark.
    void prepareBeside(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                       const HiddenParts& other);

    bool isBeside() const { return darkened_ != nullptr; }

    const Scene& scene() const { return *scene_; }
    const RenderSettings& settings() const { return settings_; }
    const RayTracer& tracer() const { return *tracer_; }
    PathFrame paths() const {
        return {darkened_ ? darkened_->scene : *scene_, *tracer_, settings_, materials_, lights_};
    }
    /// Radiance of the surroundings that comes to a point of a surface with this normal, from a direction.
    Colour fromSurroundings(Vec3 origin, Vec3 direction, Vec3 normal) const;
    /// The same of a lobe, not of all that is before a surface.
    Colour fromSurroundings(Vec3 origin, Vec3 direction) const;

  private:
    /// The scene with hidden triangles that emit nothing.
    struct Darkened {
        Scene scene;
        std::vector<ShadingTriangle> shading;
    };

    const Scene* scene_ = nullptr;
    const RayTracer* tracer_ = nullptr;
    RenderSettings settings_;
    MaterialTable materials_;
    LightSet lights_;
    FogMedium fog_;
    std::shared_ptr<const Darkened> darkened_;
};

} // namespace rtcore
