/// The light of what is shown, in lux and candela per square metre.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/look/light_units.h"
#include "rtcore/render/light_probe.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rtserver {

/// What is measured: owned, for a thread of its own.
struct MeasuredScene {
    std::shared_ptr<const rtcore::Scene> scene;
    std::shared_ptr<const rtcore::RayTracer> tracer;
    rtcore::RenderSettings settings;
};
MeasuredScene measuredScene(const Document& document);

/// One thread. The scene must outlive it. What it measures is the same for any number of threads.
class Photometer {
  public:
    explicit Photometer(const MeasuredScene& measured);
    Photometer(const Photometer&) = delete;
    Photometer& operator=(const Photometer&) = delete;

    /// Of points off all surfaces; lx. Throws rtcore::FileError Stopped when control.cancel was set.
    std::vector<rtcore::MeasuredLight> illuminance(std::span<const rtcore::WhitePoint> points,
                                                   const rtcore::ProbeEffort& effort,
                                                   rtcore::RenderControl& control);
    /// Along a ray of the camera; cd/m^2. Throws the same.
    rtcore::MeasuredLight luminance(const rtcore::Ray& ray, const rtcore::ProbeEffort& effort,
                                    rtcore::RenderControl& control);

    /// "300 lx of the sky, 212 lx of other light"; "" where all is the one or the other.
    std::string partsText(const rtcore::MeasuredLight& light, const char* unit) const;
    /// Which of the light has no absolute unit; "" where all of it has.
    std::string unitText() const;

  private:
    const MeasuredScene& measured_;
    rtcore::LightByUnit light_;
    rtcore::LightProbe probe_;
};

/// "512.3 lx, standard error 3.1": with two digits of the error.
std::string measuredText(const rtcore::MeasuredLight& light, const char* unit);

} // namespace rtserver
