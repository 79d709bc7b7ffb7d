#include "rtserver/loop/state_revision.h"

#include <span>
#include <utility>

namespace rtserver {

std::uint64_t StateRevision::of(const Workspace& state, bool idle) {
    if (!state.document.ready()) return revision_;
    const EditHistory& history = state.document.history();
    const Snapshot shown = state.document.snapshot();
    const std::span<const rtcore::KeyBinding> bindings = state.walk.bindings().list();
    Key key{.scene = shown.scene,
            .bookmarks = shown.bookmarks,
            .measures = shown.measures,
            .notes = shown.notes,
            .flights = shown.flights,
            .variants = shown.variants,
            .source = state.document.world().source,
            .settings = shown.settings,
            .bindings = {bindings.begin(), bindings.end()},
            .position = history.position(),
            .history = history.state(),
            .undo = history.last() != nullptr ? history.last()->number : 0,
            .redo = history.next() != nullptr ? history.next()->number : 0,
            .modified = state.document.modified()};
    const bool moved = idle && camera_ != shown.camera;
    if (idle) camera_ = shown.camera;
    if (key_ == key && !moved) return revision_;
    key_ = std::move(key);
    return ++revision_;
}

} // namespace rtserver
