/// Forms of what is said of imported models. Earlier versions wrote warnings into .bsp files as text, of
/// which readAs() finds the form again.
#pragma once

#include <array>

namespace rtcore::import_forms {

inline constexpr const char *
    kMissingTexture = "texture {0} is missing; its material is plain",
   *kMissingTextures = "{0} textures are missing, so their materials are plain: {1}",
   *kEmptyTexture = "texture {0} is empty; its material is plain",
   *kBadTexture = "texture {0}; its material is plain",
   *kTurnedTexture = "a texture is turned on its surface; that is not supported, so it is not turned",
   *kLaidAlike = "the textures of material {0} lie on it in different ways; all are laid as the first one is",
   *kEvenCoat = "the coat of varnish of material {0} is even: the mean of its textures",
   *kLightLeftOut =
       "light {0} is left out: it is not a point, directional, spot or area light, or gives no light",
   *kCameraLeftOut = "camera {0} is left out: it looks nowhere",
   *kMissingLibrary = "material library {0} is missing; what it describes is plain grey",
   *kMissingLibraries = "material library {0} are missing; what it describes is plain grey",
   *kForeignLibrary = "material library {0} is not read, as it lies outside of the model's folder; what it "
                      "describes is plain grey: put it beside the model",
   *kForeignLibraries =
       "material library {0} are not read, as they lie outside of the model's folder; what they "
       "describe is plain grey: put them beside the model",
   *kOddStatement = "{0}, line {1}: {2} is not understood and passed over",
   *kTwoOddStatements = "{0}, line {1}: {2} is not understood and passed over, as is {3} line more",
   *kOddStatements = "{0}, line {1}: {2} is not understood and passed over, as are {3} lines more",
   *kLinesAndPoints = "{0} lines and points are left out; only surfaces are shown",
   *kNeeds = "{0}: part of it is missing or wrong here", *kIgnored = "ignored, since not supported: {0}",
   *kIgnoredLost = "ignored, since not supported: {0}; lost: {1}",
   *kPlainLuminaires = "lights of the profile {0} shine to all sides alike: {1}",
   *kBrokenMeshes = "{0} of its meshes are left out: their data are damaged or missing",
   *kBrokenLists = "{0} lists of normals, colours, texture coordinates or joints are damaged and left out",
   *kDamagedPoints = "{0} of {1} points are left out: their coordinates are no numbers or beyond 1e12",
   *kEqualPoints = "{0} of {1} points are left out: they lie where others do",
   *kLostObjects = "{0} of its components are left out: they name objects that do not exist",
   *kLostColours = "{0} triangles name colours or materials that do not exist, and are plain grey",
   *kLayersApart =
       "the images of multiproperties lie on them in different ways; all are laid as the lowest one is",
   *kUnevenLayers = "colours below images vary over triangles; each image is laid on one colour",
   *kNoAnimation = "it has no animation, so it stands as its nodes say",
   *kBrokenChannels = "channels of its animation that are damaged and passed over: {0}",
   *kLostJoints = "joints of its skins that are missing: {0}; what they would move goes with the others",
   *kLostInstanceMaterials =
       "{0} meshes of nodes that show the geometry of another have its materials: their own are "
       "not read, as no node uses them first",
   *kBrokenTargets = "morph targets that do not fit their meshes and are left out: {0}",
   *kDamaged = "{0} of {1} triangles were damaged and left out: {2}",
   *kOneDamaged = "{0} of {1} triangles was damaged and left out: {2}",
   *kOnlyDamaged = "{0} of {1} triangle was damaged and left out: {2}",
   *kEqual = "{0} triangles are the third or a further one of the same corners and left out",
   *kOneEqual = "{0} triangle is the third or a further one of the same corners and left out",
   *kInvisible = "every material is fully transparent, so nothing can be seen; give them an opacity",
   *kOutliers =
       "a few vertices lie more than 100000 times as far off as all others, which are too small to be "
       "seen beside them; remove them or place the camera yourself",
   *kCoarse =
       "the file has its corners in numbers that are {0} units coarse so far from its zero; export it nearer "
       "to zero, or in a format with more digits (PLY of doubles, OBJ)",
   *kMore = "there are more warnings than these",
   *kWrapped = "textures that are clamped or mirrored in this Collada file repeat instead",
   *kOrthographic = "orthographic cameras of this Collada file become perspective ones",
   *kCutOff = "it is cut off: {0} of at least {1} bytes are there; copy it again",
   *kNoEndMark = "it is cut off: {0} is missing at its end; copy it again",
   *kNoContents = "it is cut off: the list of what it holds is missing at its end; copy it again",
   *kNeedsOne = "it needs {0}, which is not read; {1}",
   *kNeedsMore = "it needs {0} and {1}, which are not read; {2}";

// Remedies for glTF files that need what is not read.
inline constexpr const char *kWithoutQuantization = "export without it (gltfpack -noq, without -c and -cc)",
                            *kWithoutMeshopt = "export without it (gltfpack without -c and -cc)",
                            *kWithoutBasis =
                                "export with images of PNG or JPEG (gltfpack without -tc and -tu)",
                            *kWithoutWebp = "export with images of PNG or JPEG (gltfpack without -tw)",
                            *kPlainImages = "export with images of PNG or JPEG",
                            *kWithoutInstancing =
                                "export with a node for each instance (gltfpack without -mi)",
                            *kWithout = "export without it";

// Parts of them.
inline constexpr const char *kNoNumbers = "{0} with coordinates that are no numbers or beyond 1e12",
                            *kNoCorners = "{0} with corners that do not exist", *kNoArea = "{0} without area",
                            *kAndMore = "{0}' and {1} more", *kAnd = "{0}' and '{1}", *kComma = "{0}, {1}",
                            *kOf = "{0}: {1}";

/// In the order in which they are to be tried.
inline constexpr std::array kAll{kMissingTexture,
                                 kMissingTextures,
                                 kEmptyTexture,
                                 kBadTexture,
                                 kTurnedTexture,
                                 kLaidAlike,
                                 kEvenCoat,
                                 kLightLeftOut,
                                 kCameraLeftOut,
                                 kMissingLibrary,
                                 kMissingLibraries,
                                 kForeignLibrary,
                                 kForeignLibraries,
                                 kOddStatements,
                                 kTwoOddStatements,
                                 kOddStatement,
                                 kLinesAndPoints,
                                 kIgnored,
                                 kDamagedPoints,
                                 kEqualPoints,
                                 kLostObjects,
                                 kLostColours,
                                 kLayersApart,
                                 kUnevenLayers,
                                 kNoAnimation,
                                 kBrokenChannels,
                                 kLostJoints,
                                 kLostInstanceMaterials,
                                 kBrokenTargets,
                                 kDamaged,
                                 kOneDamaged,
                                 kOnlyDamaged,
                                 kEqual,
                                 kOneEqual,
                                 kInvisible,
                                 kOutliers,
                                 kCoarse,
                                 kMore,
                                 kWrapped,
                                 kOrthographic,
                                 kCutOff,
                                 kNoContents,
                                 kNoEndMark,
                                 kNeeds,
                                 kNeedsMore,
                                 kNeedsOne,
                                 kWithoutQuantization,
                                 kWithoutMeshopt,
                                 kWithoutBasis,
                                 kWithoutWebp,
                                 kPlainImages,
                                 kWithoutInstancing,
                                 kWithout,
                                 kNoNumbers,
                                 kNoCorners,
                                 kNoArea,
                                 kOf,
                                 kAndMore,
                                 kAnd,
                                 kComma};

} // namespace rtcore::import_forms
