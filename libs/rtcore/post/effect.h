/// A step between the light that was traced and tone mapping. An effect is a pair of files with a class and a
/// row like these, its settings, and the name of the row in effects.cpp.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace rtcore {

class Aovs;
class UNet;
struct Guides;
struct NetReport;
struct SampleHalves;

/// Parameters shared by all effects of an image.
struct EffectRun {
    const RenderSettings& settings; ///< of the whole image, which may be smaller or larger than they say
    int threads = 0;                ///< 0 = all cores
    float exposure = 1;             ///< the constant c of L = Y / (Y + c); for EffectStage::Display
    std::shared_ptr<const UNet> net = {};    ///< of netOf() the settings; null: there is none
    const Guides* guides = nullptr;          ///< of the frame; null: it has none
    const std::atomic<bool>* stop = nullptr; ///< null: never; true: return soon, with an undefined image
    const SampleHalves* halves = nullptr;    ///< of the image that a net takes; null: none
    const HdrImage* steady = nullptr;        ///< Frame::steady, for a net's image; null: none
    const std::vector<std::uint8_t>* covered = nullptr; ///< Frame::covered; null: not known
    const HdrImage* transmitted = nullptr;              ///< Frame::transmitted; null: none
    std::optional<Colour> behind = {};                  ///< Frame::behind
    NetReport* netReport = nullptr;                     ///< gets the effect of a net; null: not told
    std::vector<float>* netErrors = nullptr;   ///< gets EstimatedError::pixels, or none; null: not told
    std::atomic<float>* netFraction = nullptr; ///< gets how far a net is, 0..1; null: not told
};

/// The pixels from column `left` to before `right` of row `y` of an image of `width` x `height`.
struct RowPart {
    int y, left, right, width, height;
};

/// Keeps its memory, so that an image of the size of the one before allocates nothing. Not for several
/// threads at once, except changeRow(): it uses `run.threads` itself, and gives the same bits for any number
/// of them.
class Effect {
  public:
    virtual ~Effect() = default;

    /// A whole image with the effect, valid until the next call; `picture` itself where nothing changes.
    /// `aovs` are the frame's, or empty.
    virtual const HdrImage& apply(const HdrImage& picture, const Aovs& aovs, const EffectRun& run);

    /// Learns from a whole image what parts of it need to know. `coarse` has a pixel for each `block` x
    /// `block` of the image whose rows are changed. False: rows stay as they are.
    virtual bool beginRows(const HdrImage& coarse, int block, const EffectRun& run);

    /// A part of a row, after beginRows(). `radiance` and `changed` begin at column 0 and may be the same.
    virtual void changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const;
};

enum class EffectStage {
    Radiance, ///< whole frames by apply(), which HDR images show, too; parts of a preview by rows
    Display   ///< by rows everywhere, with the exposure; again whenever the exposure changes
};

/// One row of the list.
struct EffectRow {
    std::string_view name;
    EffectStage stage;
    bool (*wanted)(const RenderSettings&);
    std::size_t bytesPerPixel; ///< that apply() keeps, beside the frame and its AOVs
    bool needsAovs;            ///< it works by AOVs of the frame, and not on frames without
    bool needsGuides;          ///< the same of guides
    std::unique_ptr<Effect> (*make)();
};

template <typename Made>
std::unique_ptr<Effect> makeEffect() {
    return std::make_unique<Made>();
}

} // namespace rtcore
