/// Indirect light that the images of a run share, so that it neither flickers from frame to frame nor is
/// learned for each anew.
#pragma once

#include "renderer/light_learning.h"
#include "renderer/renderer_options.h"

#include "common/progress/progress.h"

#include "rtcore/gathering/indirect_state.h"
#include "rtcore/scene/scene_light.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace renderer {

/// That of --light; or that of a list, learned of its views before the first image, and written to the file
/// of
/// --light where that is missing. Both must outlive it.
class SharedLight {
  public:
    SharedLight(const RendererOptions& options, app::Progress& progress)
        : options_(options), progress_(progress) {}

    /// Whether an image by such settings is lit by it at all.
    static bool lights(const rtcore::RenderSettings& settings);

    /// What images of that scene share, by settings that lights() is true of; null: nothing, each learns the
    /// light of its own view. `views` are those of the list that have that light, none where there is no
    /// list; asked for once. Throws rtcore::FileError: NoInput, BadData for a file that is damaged or of
    /// another scene; Stopped.
    std::shared_ptr<const rtcore::IndirectState> of(const LitScene& lit,
                                                    const std::function<std::vector<LightView>()>& views);
    /// Warns once, where there is a file of --light, that an image is not lit by it.
    void tellUnused();

  private:
    /// What .cam files change.
    struct Switches {
        std::vector<rtcore::SceneLight> lights;
        int environment = 0;
        friend bool operator==(const Switches&, const Switches&) = default;
    };
    std::shared_ptr<const rtcore::IndirectState> read(const LitScene& lit) const;
    std::shared_ptr<const rtcore::IndirectState> learn(const LitScene& lit,
                                                       const std::vector<LightView>& views) const;
    void keep(const LitScene& lit, const rtcore::IndirectState& light) const;

    const RendererOptions& options_;
    app::Progress& progress_;
    bool toldUnused_ = false;
    std::optional<Switches> switches_; ///< those that the light is of, once it is known
    std::shared_ptr<const rtcore::IndirectState> light_;
};

} // namespace renderer
