/// A number of what `state` and `bindings` answer, so that clients need not ask to learn that nothing
/// changed.
#pragma once

#include "rtserver/walk/workspace.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace rtserver {

/// One thread.
class StateRevision {
  public:
    /// Grows whenever the answers are others than at the last call. Of the camera only where it came to rest
    /// (`idle`): a status says itself where that moves.
    std::uint64_t of(const Workspace& state, bool idle);

  private:
    struct Key {
        std::shared_ptr<const rtcore::Scene> scene;
        std::shared_ptr<const rtcore::SceneBookmarks> bookmarks;
        std::shared_ptr<const rtcore::KeptMeasures> measures;
        std::shared_ptr<const rtcore::SceneNotes> notes;
        std::shared_ptr<const rtcore::Flights> flights;
        std::shared_ptr<const VariantBook> variants;
        std::filesystem::path source;
        rtcore::RenderSettings settings;
        std::vector<rtcore::KeyBinding> bindings;
        std::uint64_t position = 0, history = 0;
        int undo = 0, redo = 0; ///< numbers of the steps
        bool modified = false;
        friend bool operator==(const Key&, const Key&) = default;
    };

    std::optional<Key> key_;
    rtcore::Camera camera_;
    std::uint64_t revision_ = 0;
};

} // namespace rtserver
