#include "common/cli/help_text.h"

#include "rtcore/simd/instruction_set.h"

// RT_VERSION and RT_HAS_... come from the build system, for this file alone; _OPENMP from the compiler.

namespace app {

namespace {

std::string feature(const std::string& name, bool present, const std::string& without) {
    return "  " + name + ": " + (present ? "yes" : "no (" + without + ")") + "\n";
}

} // namespace

std::string suiteVersion() { return RT_VERSION; }

std::string versionText(const ProgramSpec& spec) {
#ifdef _OPENMP
    constexpr bool kOpenMp = true;
#else
    constexpr bool kOpenMp = false;
#endif
    std::string text = spec.name + " (rtsuite) " RT_VERSION "\nLicence MIT. Built with:\n";
    text += feature("OpenMP", kOpenMp, "one thread renders");
    text += feature("ImageMagick", RT_HAS_MAGICK != 0, "only the common image formats");
    text += feature("OpenEXR", RT_HAS_OPENEXR != 0, "no .exr images");
    for (const Feature& each : spec.features) text += feature(each.name, each.present, each.without);
    text += "Vector code: " + rtcore::instructionSet() + ", of";
    for (const std::string& name : rtcore::instructionSets()) text += " " + name;
    return text + "; RT_ISA chooses another\n";
}

} // namespace app
