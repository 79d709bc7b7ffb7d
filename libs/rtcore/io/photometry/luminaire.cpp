#include "rtcore/io/photometry/luminaire.h"

#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/scene/light_power.h"

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
    light.light.photometry = keepPhotometry(file.web);
    if (!light.lumens) return;
    scaleTo(*light.lumens > 0 ? double{*light.lumens} : lumensOf(file.web), metresPerUnit, light);
    light.lumens.reset();
}

} // namespace rtcore
