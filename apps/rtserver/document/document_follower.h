/// Follows edits at once, as the walk in a document has to.
#pragma once

#include "rtcore/scene/revisions.h"
#include "rtcore/scene/scene.h"

namespace rtserver {

/// Told by the Document that it follows when an edit is done, in the thread that edits.
class DocumentFollower {
  public:
    virtual ~DocumentFollower() = default;
    /// Another scene is shown.
    virtual void sceneOpened() = 0;
    /// Changes of these kinds were made to the scene; none where only names changed.
    virtual void sceneEdited(const rtcore::Scene& before, const rtcore::Changes& changes) = 0;
    /// Another tree of what is visible; the triangles are the same.
    virtual void treeReplaced() = 0;
    /// Another up axis or unit, and the camera that goes with it.
    virtual void unitsChanged() = 0;
    /// By an edit, and not by Document::moveCamera().
    virtual void cameraPlaced() = 0;
};

} // namespace rtserver
