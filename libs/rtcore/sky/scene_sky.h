/// The sky of a scene, and the environments beside it: what they are, and what the scene is lit by of them.
#pragma once

#include "rtcore/scene/scene.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace rtcore {

/// Gives the scene that sky in place of its last one, or none: its environment, which stands behind those of
/// files and becomes the active one when there was no sky, and its light, named "sun", which stands behind
/// the others and is switched as the last one was; its ground, when it has one. A studio has no sun. Edits of
/// the last sun are lost. Without a sky the first environment of files takes the place of that which was
/// active. The sky is what is kept of them in files, and the sun where it was edited. Some 0.05 s.
void setSky(Scene& scene, const std::optional<Sky>& sky);

/// The number of the sky's environment and of its light; nothing when there is no sky, or its light was taken
/// away or became another: it got another name or is of another kind.
std::optional<std::size_t> skyEnvironmentOf(const Scene& scene);
std::optional<std::size_t> sunOf(const Scene& scene);
/// Whether the sky's light is not, but for being on or off, what the sky makes it.
bool isSunEdited(const Scene& scene);
/// Lets that light, a directional one, be the sky's in place of the one that it has.
void replaceSun(Scene& scene, std::size_t light);

/// A copy without the megabytes of its sky's map, to be kept for later and not to be rendered, and the way
/// back, to the same bits. `like` may be null: where it has the same sky, its map is shared.
std::shared_ptr<const Scene> withoutSkyMap(const std::shared_ptr<const Scene>& scene);
Scene withSkyMap(const Scene& scene, const Scene* like);

/// Behind all other lights, where it stands when a scene is loaded: rays are drawn by the lights' order.
void moveSunBehind(Scene& scene);

/// Adds an environment of files behind the others of files; returns its number.
std::size_t addEnvironment(Scene& scene, const EnvironmentFile& file, Environment environment);

/// Sets the intensity of an environment of files.
void setEnvironmentIntensity(Scene& scene, std::size_t environment, float intensity);
void setEnvironmentRotation(Scene& scene, std::size_t environment, float degrees);

/// After Scene::up was changed: sky and environments stand upright again.
void straightenSky(Scene& scene);

} // namespace rtcore
