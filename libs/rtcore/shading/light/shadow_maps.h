/// Shadow maps: the distance to the nearest surface seen from each light, for images that have to be quick.
/// (Williams 1978)
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/math/box.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace rtcore {

class ShadowTracer;
struct LightEnd;

/// Shadow map of one light; one with a size counts as a point in its middle. A square of texels for
/// directional lights, else the six sides of a cube around the light. Immutable; any number of threads.
class ShadowMap {
  public:
    /// The fraction of the light that arrives at a point of a surface with that unit normal, on the side of
    /// the light; `normal` zero: at a point of the air. Shadows are as fine as the texels, and leave what
    /// throws them by as much.
    Colour arriving(Vec3 position, Vec3 normal) const;

  private:
    friend class ShadowMaps;
    struct Texel {
        float squareClear = 0, squareReach = 0; ///< how far all light gets, and some of it; scene units
        std::uint8_t tint[4] = {};              ///< what is left between the two, in 255ths
    };
    struct Lookup {
        std::size_t texel;
        float squareDistance; ///< from the light, or from the plane in which the sun's light begins
    };
    ShadowMap(const Light& light, const Box3& bounds, std::size_t texels);
    float texelWidth(Vec3 position) const;
    Lookup lookUp(Vec3 position) const;
    Ray rayThrough(int side, int column, int row) const;
    bool fill(ShadowTracer& shadows, const std::atomic<bool>& cancel); ///< false: it was cancelled
    void set(std::size_t texel, const LightEnd& end);

    Light light_;
    Vec3 across_, along_, start_; ///< directional: the plane's axes, unit, and its middle
    float half_ = 0;              ///< directional: half a side of the square
    float nearest_ = 0;           ///< nearer surfaces cast no shadow: a light may lie inside its fitting
    int side_ = 0, sides_ = 0;
    std::vector<Texel> texels_;
};

/// Shadow maps of all lights of a scene, on or off.
class ShadowMaps {
  public:
    /// By one thread: some hundred thousand rays a light, fewer where lights are many. Null when `cancel` was
    /// set, and where there are more than a thousand lights.
    static std::unique_ptr<const ShadowMaps> make(const Scene& scene, const RayTracer& tracer,
                                                  const std::atomic<bool>& cancel);
    /// Whether shadows are like that with these settings.
    bool suit(const RenderSettings& settings) const;
    const ShadowMap& of(std::size_t light) const { return maps_[light]; }

  private:
    bool tinted_ = false;
    std::vector<ShadowMap> maps_;
};

} // namespace rtcore
