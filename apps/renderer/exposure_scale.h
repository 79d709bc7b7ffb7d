/// Common to all images of a list: how much brighter they are than by Whitted's rays, for which a
/// recording's exposures are, and the scale of their false colours.
#pragma once

#include "rtcore/io/text/cam.h"
#include "rtcore/post/value_scale.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/settings/settings_table.h"

#include <span>

namespace renderer {

/// Whether the command line has an exposure, which counts for all images.
bool saysExposure(std::span<const rtcore::SettingAssignment> commandLine);

/// A small image of the view, without effects. The same everywhere, with the same exception as below.
void renderSmall(const rtcore::View& view, rtcore::RenderControl& control, rtcore::ImageRenderers& images,
                 rtcore::Frame& frame);

/// Whether an image of `camera` has the exposure that is recorded there, and not one of `commandLine`.
bool hasRecordedExposure(const rtcore::CameraFile& camera,
                         std::span<const rtcore::SettingAssignment> commandLine);

/// The mean luminance of the view by the integrator of its settings over that by Whitted's rays, of small
/// images: what the constant of a recorded exposure is multiplied by. 1 where one of the images is black. A
/// function of the view alone: the same bits for any number of threads and any instruction set. Throws
/// rtcore::FileError Stopped when control.cancel was set.
float exposureScale(const rtcore::View& view, rtcore::RenderControl& control, rtcore::ImageRenderers& images);

/// The scale of false colours that suits a small image of the view, with the ends that its settings give. The
/// same everywhere, too, and with the same exception.
rtcore::ValueScale valueScaleOf(const rtcore::View& view, const rtcore::LuminanceUnit& unit,
                                rtcore::RenderControl& control, rtcore::ImageRenderers& images);

} // namespace renderer
