#include "gui/models/camera_keys.h"

#include "rtcore/motion/key_bindings.h"

namespace gui {

CameraKeys::CameraKeys(const QList<Binding>& bindings) {
    for (const Binding& binding : bindings) {
        const QStringList names = keyNames(binding.keys);
        const int code = rtcore::keyNamed(names.last().toStdString()).value_or(rtcore::KeyNone);
        const std::optional<rtcore::Action> action = rtcore::actionNamed(binding.action.toStdString());
        if (names.size() > 1)
            pairs_.insert({rtcore::keyNamed(names.first().toStdString()).value_or(rtcore::KeyNone), code});
        else if (action && rtcore::isHeld(*action))
            moving_.insert(code);
    }
}

} // namespace gui
