/// Outlines of storeys as the command `plan outline` tells them, kept until something else is shown.
#pragma once

#include "rtcore/plans/storeys.h"
#include "rtcore/scene/scene.h"
#include "rtcore/sections/closed_pieces.h"

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace rtserver {

/// Each is found once for a model, its hidden parts, up axis and unit. Safe from many threads, which wait for
/// each other: it is for threads that may take their time. Keeps neither a model that is not shown any more
/// nor what was found of it once the next one is asked for.
class StoreyOutlines {
  public:
    struct Order {
        std::shared_ptr<const rtcore::Scene> scene;
        rtcore::Box3 bounds;       ///< of its model
        std::optional<int> storey; ///< from 1; nothing: by `eye`
        rtcore::Vec3 eye;          ///< of the camera, in the scene
        std::size_t maxBytes;      ///< of the text: lines of fewer points where they are too many
    };
    /// As app::formatOutline() writes it. Throws rtcore::Refusal where there is no such storey, or `cancel`
    /// was set.
    std::string text(const Order& order, const std::atomic<bool>& cancel);

  private:
    void begin(const Order& order);
    std::string make(const Order& order, int storey, const std::atomic<bool>& cancel);

    std::mutex mutex_;
    std::weak_ptr<const void> storage_; ///< of the model
    rtcore::HiddenParts hidden_;
    rtcore::Vec3 up_;
    float metresPerUnit_ = 0;
    std::vector<rtcore::Storey> storeys_;
    std::map<int, std::string> texts_; ///< by storey
};

} // namespace rtserver
