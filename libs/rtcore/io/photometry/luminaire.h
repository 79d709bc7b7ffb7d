/// Lights that are luminaires of a photometric file.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <vector>

namespace rtcore {

/// Reads the file of a description, if it names one, and gives the light its distribution, and where lumens
/// are to be counted its intensity: candelas are 683 to a watt per steradian, and distances of scenes in
/// scene units. Appends what of the file does not count, with its name. Throws FileError NoInput or BadData,
/// and as keepPhotometry().
void readLuminaire(LightDescription& light, float metresPerUnit, std::vector<Sentence>& warnings);

} // namespace rtcore
