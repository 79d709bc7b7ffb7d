#include "rtcore/io/import/assimp/format_quirks.h"

#include <algorithm>
#include <array>

namespace rtcore {

namespace {

// Formats made for OpenGL and Direct3D of old, where the texture multiplies the sum of all light.
constexpr std::array kFixedFunction{"3DS", "ASE", "AC3D", "BlitzBasic", "LightWave", "Milkshape", "XFile"};

// ASE has none, and what MDL has is of no use.
constexpr std::array kSkins{"Collada",    "Autodesk FBX", "Doom 3",   "Direct3D XFile",
                            "BlitzBasic", "Milkshape 3D", "Valve SMD"};

} // namespace

FormatQuirks quirksOf(const std::string& importer) {
    FormatQuirks q;
    const auto is = [&](const char* part) { return importer.find(part) != std::string::npos; };
    if (is("glTF")) {
        q.linearVertexColours = q.physicalLights = q.halfSpotAngles = true;
        q.cameraAtNode = q.fovTimesAspect = q.framedAspect = q.metresAndYUp = true;
    }
    if (is("Stereolithography")) q.facetNormals = true;
    if (is("Collada"))
        q.oneSpotAngle = q.mapReplacesDiffuse = q.framedAspect = q.metresAndYUp = q.indexByHabit = true;
    if (is("Collada")) q.gouraudIsMatte = true;
    if (is("FBX")) q.mapReplacesDiffuse = q.ownAxes = q.fbxNotes = true;
    if (is("IFC")) q.metresAndYUp = true; // turned and scaled by its units
    if (is("MD5")) q.md5 = true;
    if (is("XFile")) q.ticksPerSecond = 4800;
    q.bindMatrices = std::ranges::any_of(kSkins, is);
    if (is("3DS")) q.lightsInRoot = true;
    if (is("Blender")) q.ignoredColours = true;
    if (is("ASE")) q.cameraBackwards = true;
    q.mapScalesEmission = std::ranges::any_of(kFixedFunction, is);
    return q;
}

} // namespace rtcore
