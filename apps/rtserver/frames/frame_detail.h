/// How much of a frame is drawn: a coarse one shows a change at once, the whole one follows.
#pragma once

#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

namespace rtserver {

/// Whose indirect light a whole frame shows; others show what the walk has learned.
enum class IndirectOf {
    View, ///< what the view alone decides
    Rest, ///< what the walk knows, once that is much about this view
    Walk  ///< what the walk knows by now, while the camera moves
};

struct FrameDetail {
    double scale = 1; ///< times the width and the height that are asked for: 1/8 to 1
    bool cut = false; ///< few samples in place of those that are asked for
    /// The fraction of a live frame's pixels (rtcore/live) that is traced; the others show the light of the
    /// frames before. 0: all are traced.
    double newSamples = 0;
    /// The fraction of WalkLight::kBudget by which a live or coarse frame learns indirect light; in a live
    /// one above 1, up to 4: as far as nothing is known of what is seen.
    double learning = 1;
    IndirectOf indirect = IndirectOf::View;

    bool whole() const { return scale == 1 && !cut; }
    /// Whether it shows a view that stands as well as it will be shown.
    bool complete() const { return whole() && indirect != IndirectOf::Walk; }
    /// Whether it depends on the state alone, not on what was drawn before.
    bool exact() const { return whole() && indirect == IndirectOf::View; }
    bool live() const { return newSamples > 0; }
    friend bool operator==(const FrameDetail&, const FrameDetail&) = default;
};

inline constexpr double kMinScale = 0.125, kMinLiveScale = 1.0 / 3;
inline constexpr FrameDetail kCoarsest{kMinScale, true};

/// The settings of a frame of that detail: `settings` themselves for a whole one.
rtcore::RenderSettings settingsAt(const rtcore::RenderSettings& settings, const FrameDetail& detail);

/// The same for a live one: one sample per pixel, in as much light as the whole frame, whatever its size, so
/// that the light holds for frames of another size.
rtcore::RenderSettings liveSettingsAt(const rtcore::RenderSettings& settings, const rtcore::Scene& scene,
                                      double scale);
/// About the rays of each of its pixels that is traced.
double liveRays(const rtcore::RenderSettings& settings, const rtcore::Scene& scene);

/// About the rays of such a frame, to compare frames of one scene by. `mapped`: shadows are looked up.
double workOf(const rtcore::RenderSettings& settings, const rtcore::Scene& scene, bool mapped = false);

} // namespace rtserver
