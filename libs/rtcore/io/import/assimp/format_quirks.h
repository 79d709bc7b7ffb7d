/// The meaning of Assimp 5.2's data by format: its importers do not agree.
#pragma once

#include <optional>
#include <string>

namespace rtcore {

struct FormatQuirks {
    bool linearVertexColours = false;  ///< else encoded as sRGB, as colours of one byte are
    bool ignoredColours = false;       ///< of vertices: materials do not show them
    bool facetNormals = false;         ///< the file's normals are those of triangles, not of vertices
    bool physicalLights = false;       ///< candela and lux; else brightness of the image
    bool halfSpotAngles = false;       ///< else the angle is that of the whole cone
    bool oneSpotAngle = false;         ///< the outer angle is made up, the inner one is the cone
    bool lightsInRoot = false;         ///< lights and cameras stand relative to the root, not to their node
    bool cameraAtNode = false;         ///< the camera's own position repeats its node's
    bool cameraBackwards = false;      ///< cameras look along -z whatever is said
    bool fovTimesAspect = false;       ///< the camera's angle is the vertical one times the aspect ratio
    bool framedAspect = false;         ///< a camera has the aspect that its author framed; else a made up one
    bool metresAndYUp = false;         ///< by the format, or made so by Assimp from what the file says
    bool ownAxes = false;              ///< up axis and unit stand in the file; Assimp leaves both as they are
    bool mapReplacesDiffuse = false;   ///< a diffuse image stands in place of the diffuse colour
    bool indexByHabit = false;         ///< exporters write an index of refraction for every material
    bool gouraudIsMatte = false;       ///< shading model Gouraud stands for lambert, which has no highlight
    bool bindMatrices = false;         ///< bones have the matrices that skins need
    bool md5 = false;                  ///< its animation stands in a file of its own
    bool fbxNotes = false;             ///< much of it is left to fbx_notes.h
    double ticksPerSecond = 25;        ///< of animations that do not say it
    std::optional<double> statedTicks; ///< of all animations, in place of what Assimp says
    bool displayColours = false;       ///< of materials: codes as displays show them, not linear
    bool mapScalesEmission = false;    ///< a diffuse image multiplies the emission, too
};

/// By Assimp's name for its importer.
FormatQuirks quirksOf(const std::string& importer);

} // namespace rtcore
