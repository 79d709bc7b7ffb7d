/// The scale of false colours: which luminance or illuminance has which colour.
#pragma once

#include "rtcore/scene/image.h"
#include "rtcore/scene/luminance_unit.h"
#include "rtcore/settings/render_settings.h"

#include <optional>
#include <vector>

namespace rtcore {

/// Logarithmic. 0 < from < to, in the unit of the image.
struct ValueScale {
    float from = 1, to = 10;
    friend bool operator==(const ValueScale&, const ValueScale&) = default;
};

/// `unit`, or for illuminance pi times as much: that of white matte paper of that luminance.
LuminanceUnit shownUnit(const LuminanceUnit& unit, LightQuantity quantity);

/// Whether it has more than four powers of ten, and round numbers are these alone.
bool isWide(const ValueScale& scale);

/// The numbers 1, 2 and 5 times a power of ten within the scale; of a wide one the powers of ten, or each
/// second, third and so on of them where there would be more than `max`. `max` of at least 2.
std::vector<float> roundValues(const ValueScale& scale, std::size_t max);

/// The smallest such number that is not below `value` or, `up` being false, the largest that is not above it;
/// within 1e-6 of it. `value` within 1e-37 to 1e37.
float roundValue(float value, bool up);

/// Chooses scales, and keeps its memory.
class ScaleChoice {
  public:
    /// The scale that the settings ask for. An end that they leave open is a round number that 99 of 100
    /// pixels of the image do not exceed: the lower one likewise; one to four powers of ten apart; black and
    /// what is not finite does not count. With `hold`, it is the one before as long as that suits the image
    /// roughly: for images that move. `unit` of luminance, whatever is shown. The same for any number of
    /// threads and on every processor.
    ValueScale choose(const HdrImage& radiance, const FalseColourSettings& settings,
                      const LuminanceUnit& unit, bool hold);

  private:
    std::optional<ValueScale> ofImage(const HdrImage& radiance, const LuminanceUnit& unit, bool hold);

    std::vector<float> values_; ///< of some pixels
    std::optional<ValueScale> before_;
    LuminanceUnit unitBefore_;
};

} // namespace rtcore
