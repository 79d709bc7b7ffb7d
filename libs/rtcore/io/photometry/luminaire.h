/// Lights that are luminaires of a photometric file.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/photometry.h"

#include <span>
#include <vector>

namespace rtcore {

/// Reads the file of a description, if it names one, and gives the light its distribution, and where lumens
/// are to be counted its intensity: candelas are 683 to a watt per steradian, and distances of scenes in
/// scene units. Appends what of the file does not count, with its name. Throws FileError NoInput or BadData,
/// and as keepPhotometry().
void readLuminaire(LightDescription& light, float metresPerUnit, std::vector<Sentence>& warnings);

/// The same for a description that names a luminaire of the model, whose lights these are.
void takeLuminaire(std::span<const Light> modelLights, LightDescription& light, float metresPerUnit,
                   std::vector<Sentence>& warnings);

/// Gives a light of the kind ies that distribution and, where lumens are to be counted, its intensity.
/// Throws as keepPhotometry(), and BadValue where so much light cannot be counted.
void shineBy(const PhotometricWeb& web, float metresPerUnit, LightDescription& light);

} // namespace rtcore
