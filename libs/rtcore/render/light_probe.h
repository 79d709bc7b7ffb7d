/// Light as a number: irradiance at points and radiance along rays, by paths, with their standard errors.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

/// A part of the light to be measured.
struct ProbedLight {
    const Scene* scene = nullptr; ///< lit by it alone; all parts have the same surfaces
    double unit = 1;              ///< the result of a radiance of 1, or of an irradiance of 1
};

/// When a measurement ends.
struct ProbeEffort {
    double relativeError = 0.01;    ///< the standard error over the mean is at most that; 0: whatever it is
    std::uint32_t paths = 1U << 18; ///< or each part got so many; rounded up to 2^9, 2^10 and so on to 2^24
};

struct MeasuredLight {
    std::array<double, 3> colour{}; ///< linear sRGB: the mean of all paths
    double luminance = 0;           ///< of the colour
    double error = 0;               ///< standard error of the luminance
    std::vector<double> parts;      ///< luminance of each part; they add up to the whole
    std::uint32_t paths = 0;        ///< of each part
};

/// Measures one scene after another and keeps the memory of its threads. Not for several threads at once: it
/// uses those of the control itself.
///
/// Paths come in batches of 256, each of them a net of its own (sample_id.h). The batches are independent, so
/// that the spread of their means tells the standard error; there are at least 32. A glance, by an effort of
/// fewer than 2^13 paths, has batches of 64, and 8 of them at least. All light counts, of up to
/// 64 bounces, unclamped, shadows, mirrors and glass included, whatever the settings say of these.
class LightProbe {
  public:
    LightProbe();
    ~LightProbe();
    LightProbe(const LightProbe&) = delete;
    LightProbe& operator=(const LightProbe&) = delete;

    /// Scenes, tracer and settings must live, and stay as they are, while light is measured. Of the settings
    /// count textures, fog, `path.caustics`, `path.emitters` and `path.seed`: another one gives other noise.
    void begin(std::span<const ProbedLight> parts, const RayTracer& tracer, const RenderSettings& settings);

    /// Irradiance of surface elements, of which nothing is seen by others: pi times the radiance of white
    /// matte paper there. Each goes on until it is known as well as `effort` says. control.tilesDone over
    /// control.tiles is how far it is at least. False when control.cancel was set, with `measured` undefined.
    /// The same bits for any number of threads and any instruction set. At most 65536 points.
    bool irradiance(std::span<const WhitePoint> points, const ProbeEffort& effort, RenderControl& control,
                    std::vector<MeasuredLight>& measured);
    /// The same of the radiance along rays of the camera, with directions of unit length.
    bool radiance(std::span<const Ray> rays, const ProbeEffort& effort, RenderControl& control,
                  std::vector<MeasuredLight>& measured);

  private:
    struct Part;
    struct Sums;
    struct Target;
    bool measure(const Target& target, const ProbeEffort& effort, RenderControl& control,
                 std::vector<MeasuredLight>& measured);
    bool look(const Target& target, RenderControl& control);
    bool addBatches(const Target& target, std::span<const std::uint32_t> open, std::uint32_t batches,
                    RenderControl& control, std::vector<Sums>& sums);

    RenderSettings settings_; ///< of all parts
    const RayTracer* tracer_ = nullptr;
    std::vector<std::unique_ptr<Part>> parts_;
    std::vector<std::unique_ptr<PathIntegrator>> integrators_; ///< by thread
};

/// The side of the surface that the ray meets first, just off it; nothing where it meets none. `direction` of
/// unit length.
std::optional<WhitePoint> sideSeen(const Scene& scene, const RayTracer& tracer, const Ray& ray);

} // namespace rtcore
