/// Points of the scene in the image that a view shows, and of that image in the server's.
#pragma once

#include "gui/models/scene_image.h"
#include "gui/models/scene_state.h"

#include <QPointF>

#include <optional>

namespace gui {

class FrameView;
class Session;

/// Where the shown image has points of the scene; nothing: none is shown, or its camera is not known.
std::optional<SceneImage> shownImage(const FrameView& view, const Session& session, const SceneState& state);

/// Where a point of the widget is in the server's image: 0..1 from the left and from the top; nothing: beside
/// it.
std::optional<QPointF> inServersImage(const FrameView& view, const Session& session, const QPointF& at);

/// So far beyond a plane, in scene units, a point still lies in it.
double cutSlack(const SceneState& state);

} // namespace gui
