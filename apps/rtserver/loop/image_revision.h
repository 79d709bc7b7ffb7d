/// A number of what images show, for clients that render the view that rests by themselves.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/scene/revisions.h"
#include "rtcore/settings/render_settings.h"

#include <cstdint>

namespace rtserver {

/// One thread.
class ImageRevision {
  public:
    /// Grows whenever the image of a view is another than at the last call: by an edit of the scene or of the
    /// settings, but for the size of the image; where the camera stands counts for nothing. 0 before there is
    /// a scene.
    std::uint64_t of(const Document& document);

  private:
    rtcore::Subscription seen_;
    rtcore::RenderSettings settings_; ///< of the last call, of no size
    std::uint64_t revision_ = 0;
};

} // namespace rtserver
