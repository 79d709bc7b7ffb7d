/// Where the light of each lamp ends, seen from the lamp: shadows without rays, for pictures that have to be
/// quick. (Williams 1978)
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

/// Of one lamp; one with a size counts as a point in its middle. A square of texels for what shines from
/// afar, else the six sides of a cube around the lamp. Immutable; any number of threads.
class ShadowMap {
  public:
    /// The share of the light that arrives at a point of a surface with that unit normal, on the side of the
    /// lamp; `normal` zero: at a point of the air. Shadows are as fine as the texels, and leave what throws
    /// them by as much.
    Colour arriving(Vec3 position, Vec3 normal) const;

  private:
    friend class ShadowMaps;
    struct Texel {
        float squareClear = 0, squareReach = 0; ///< how far all light gets, and some of it; scene units
        std::uint8_t tint[4] = {};              ///< what is left between the two, in 255ths
    };
    struct Place {
        std::size_t texel;
        float squareDistance; ///< from the lamp, or from the plane in which the sun's light begins
    };
    ShadowMap(const Light& light, const Box3& bounds, std::size_t texels);
    float texelWidth(Vec3 position) const;
    Place place(Vec3 position) const;
    Ray rayThrough(int side, int column, int row) const;
    bool fill(ShadowTracer& shadows, const std::atomic<bool>& cancel); ///< false: it was cancelled
    void set(std::size_t texel, const LightEnd& end);

    Light light_;
    Vec3 across_, along_, start_; ///< directional: the plane's axes, unit, and its middle
    float half_ = 0;              ///< directional: half a side of the square
    float nearest_ = 0;           ///< what is nearer casts no shadow: a lamp lies in its own fitting
    int side_ = 0, sides_ = 0;
    std::vector<Texel> texels_;
};

/// Of all lamps of a scene, on or off.
class ShadowMaps {
  public:
    /// By one thread: some hundred thousand rays a lamp, fewer where lamps are many. Null when `cancel` was
    /// set, and where there are more than a thousand lamps.
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
