/// Which keys move the camera, by the bindings, and which combinations are therefore no shortcuts.
#pragma once

#include "gui/models/bindings.h"

#include <QSet>

namespace gui {

class CameraKeys {
  public:
    explicit CameraKeys(const QList<Binding>& bindings = defaultBindings());

    /// The camera moves as long as the key is down. Key codes of rtcore/motion/key_codes.h.
    bool moves(int code) const { return moving_.contains(code); }
    /// With this modifier down the key moves the camera in another way (Control+W crawls forward), or a
    /// binding names both (M+3). A key that acts once, such as a light's, has nothing from a modifier that
    /// moves.
    bool combines(int modifier, int code) const {
        return (moves(modifier) && moves(code)) || pairs_.contains({modifier, code});
    }

  private:
    QSet<int> moving_;
    QSet<std::pair<int, int>> pairs_; ///< the key that must be down, the key that acts
};

} // namespace gui
