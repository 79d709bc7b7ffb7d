/// Which way is up in a model, and how large it is: what its file says, else a guess.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/model.h"
#include "rtcore/scene/model_origin.h"

#include <optional>
#include <string>

namespace rtcore {

/// Who says it. In the order of precedence, the strongest last.
enum class Said {
    Guessed,
    ByFormat, ///< or in the model's file
    ByScene,  ///< in a .scn
    ByUser,   ///< by an option or a command
};

struct ModelUnits {
    Vec3 up{0, 1, 0};        ///< one of the six axes
    float metresPerUnit = 1; ///< above 0, finite
    Said upSaid = Said::Guessed, unitSaid = Said::Guessed;
    Vec3 otherUp{0, 0, 1};   ///< of a guess: what else it may be
    Sentence upWhy, unitWhy; ///< of what is guessed or said by the format: "its shape", "as OpenSCAD does"
    bool surprising = false; ///< what is guessed is not what most files are: worth a word
};

/// Guesses what the origin leaves open, +y or +z for the up axis and metre, centimetre, millimetre, inch or
/// foot for the unit: from the habits of its format and of the program that wrote it, from names (floors lie,
/// walls stand, and what has both is a building), and from its shape: what it stands on, where it is
/// symmetric, whether it has rooms, and how large such things are. Takes some milliseconds for a million
/// triangles. Safe from many threads.
ModelUnits guessModelUnits(const ModelOrigin& origin, const KdTree& tree, const Model& model);

/// With what the user says in place of it, where it is there.
ModelUnits withUserSays(ModelUnits units, std::optional<Vec3> up, std::optional<double> metresPerUnit);

/// One line for people: "+z is up (as OpenSCAD writes it), a unit is 1 mm (its size)".
Sentence describe(const ModelUnits& units);

} // namespace rtcore
