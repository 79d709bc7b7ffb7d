/// Guesses materials by their names, where a file has nothing but colours for them.
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace rtcore {

/// A material that is taken for what its name says: "Fensterglas", "chrome_02", "podlaha parkety".
struct MaterialGuess {
    MaterialOverride change; ///< with its number
    const char* kind = "";   ///< "glass", "water", "mirror", "chrome", "metal", "polished" or "lacquer"
};

/// None where a material has more than a colour: a texture, a mirror, transparency, light of its own, or a
/// roughness that another lacks: then they are as an author wants them. Names in English, German, French,
/// Spanish, Italian, Czech, Polish, Portuguese and Dutch; a compound counts by its last part.
std::vector<MaterialGuess> guessMaterials(const Scene& scene);

/// Makes them edits of the scene, which are kept with it and can be taken back. The scene's materials must be
/// those of its files.
void useGuesses(Scene& scene, std::span<const MaterialGuess> guesses);

/// "3 materials are guessed by name (glass, chrome)"; empty without any.
Sentence guessedText(std::span<const MaterialGuess> guesses);

} // namespace rtcore
