/// Variants of a scene: what each makes of the scene's base, and from one to another.
///
/// A variant names things - materials, parts, lights, the surroundings - and says what each is. From a
/// variant to another, things that the first names and the second does not become what they are in the base;
/// what neither names stays as it is shown, edited or not.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/scene/scene.h"

namespace rtcore {

/// A scene with what variants change beside it. Its lights are numbered.
struct VariantScene {
    Scene scene;
    bool skyLight = false; ///< the setting skyLight.on
};

/// `shown` and `base` are of the same model. An empty variant stands for none. Names without a thing in the
/// scene say nothing. Scene::closed is made again where that is needed. Some 0.05 s where skies differ.
void switchVariant(VariantScene& shown, const VariantScene& base, const SceneVariant& from,
                   const SceneVariant& to);

/// All in which `shown` differs from `base`, as a variant without a name, which makes the one of the other -
/// but for textures that the base lacks, the order of lights, and whether a light that has been replaced is
/// the sky's.
SceneVariant differences(const VariantScene& base, const VariantScene& shown);

/// The same things as `variant` names, as they are shown.
SceneVariant updated(const SceneVariant& variant, const VariantScene& base, const VariantScene& shown);

/// What a file says is shown of its base; an empty one where that is the base itself.
const SceneVariant& shownVariant(const SceneFile& file);

// Parts of these.

VariantSurroundings surroundingsOf(const VariantScene& lit);
/// With the light of the sky as the sky makes it, switched on.
void putSurroundings(VariantScene& lit, const VariantSurroundings& surroundings);
/// Whether a section is for that part, counted from 0.
bool isFor(const PartDescription& part, const NamedPart& named, std::size_t index);
/// In the order of the base; others behind them, by their ids, and the sky's last.
void sortLights(Scene& scene, const Scene& base);

} // namespace rtcore
