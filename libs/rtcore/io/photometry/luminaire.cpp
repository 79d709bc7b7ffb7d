#include "rtcore/io/photometry/luminaire.h"

#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/scene/model_photometry.h"

#include <utility>

namespace rtcore {

namespace {

/// As bright as it says, of the colour that it has.
void scaleTo(double lumens, float metresPerUnit, LightDescription& light) {
    if (!(luminance(light.light.intensity) > 0)) light.light.intensity = kWhite;
    const double power = powerOfWatts(light.light, lumens / kLumensPerWatt, double{metresPerUnit});
    const auto now = double{powerOf(tintedLight(light))};
    const Colour scaled = light.light.intensity * static_cast<float>(power / now);
    if (!isFinite(scaled)) throw BadValue("so much light cannot be counted");
    light.light.intensity = scaled;
}

} // namespace

void readLuminaire(LightDescription& light, float metresPerUnit, std::vector<Sentence>& warnings) {
    if (light.file.empty()) return;
    const PhotometricFile file = readPhotometricFile(light.file);
    for (const Sentence& warning : file.warnings)
        warnings.push_back(say("{0}: {1}", light.file.string(), warning));
    shineBy(file.web, metresPerUnit, light);
}

void takeLuminaire(std::span<const Light> modelLights, LightDescription& light, float metresPerUnit,
                   std::vector<Sentence>& warnings) {
    if (light.modelLuminaire == 0) return;
    const std::vector<std::uint32_t> numbers = photometriesOf(modelLights);
    if (std::cmp_greater(light.modelLuminaire, numbers.size())) {
        warnings.push_back(say("the model has no luminaire {0}; light {1} shines to all sides alike",
                               light.modelLuminaire, "'" + light.name + "'"));
        light.modelLuminaire = 0;
        light.lumens.reset();
        return;
    }
    shineBy(*keptWeb(numbers[static_cast<std::size_t>(light.modelLuminaire) - 1]), metresPerUnit, light);
}

void shineBy(const PhotometricWeb& web, float metresPerUnit, LightDescription& light) {
    light.light.photometry = keepPhotometry(web);
    if (!light.lumens) return;
    scaleTo(*light.lumens > 0 ? double{*light.lumens} : lumensOf(web), metresPerUnit, light);
    light.lumens.reset();
}

} // namespace rtcore
