#include "rtserver/loop/image_revision.h"

#include <utility>

namespace rtserver {

std::uint64_t ImageRevision::of(const Document& document) {
    if (!document.ready()) return revision_;
    rtcore::Changes changes = seen_.take(document.revisions());
    changes.set(rtcore::Change::View, false);
    if (!changes.any()) return revision_;
    rtcore::RenderSettings settings = document.frameSettings();
    settings.width = settings.height = 0;
    const bool others = std::exchange(settings_, settings) != settings;
    changes.set(rtcore::Change::Setting, false);
    if (others || changes.any()) ++revision_;
    return revision_;
}

} // namespace rtserver
