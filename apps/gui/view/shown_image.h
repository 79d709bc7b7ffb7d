/// The image that the viewport shows, as marks over it need it.
#pragma once

#include "gui/models/scene_image.h"
#include "gui/models/scene_state.h"

#include <QPointF>

#include <optional>

namespace gui {

class FrameView;
class Session;

/// With the camera of its frame; nothing where there is none. An image that was rendered before the window
/// had its size may have another shape than the server's.
std::optional<SceneImage> shownImage(const FrameView& view, const Session& session, const SceneState& state);

/// Of a point of the widget, where it is in the server's image: 0..1 from the left and from the top; nothing:
/// beside it.
std::optional<QPointF> inServersImage(const FrameView& view, const Session& session, const QPointF& at);

} // namespace gui
