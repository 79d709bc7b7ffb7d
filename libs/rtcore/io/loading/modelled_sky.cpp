#include "rtcore/io/loading/modelled_sky.h"

#include "rtcore/io/text/pattern.h"
#include "rtcore/look/shell_picture.h"
#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

class ModelledSky {
  public:
    explicit ModelledSky(Loading& loading) : loading_(loading), out_(loading.out) {}

    void hide() {
        Scene& scene = out_.scene;
        if (loading_.surveyed().subject.domes.empty()) return;
        const std::vector<NamedPart> parts = namedParts(scene.model);
        const std::vector<std::uint8_t> chosen = domesAmong(parts);
        if (chosen.empty())
            return loading_.warn(
                say("a sky that was modelled around it keeps the light out; make it a part of its own"));
        std::vector<std::string> names;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (chosen[i] != 0) names.emplace_back(parts[i].name);
        const bool shown = showShell(parts, chosen);
        scene.hiddenParts = withParts(scene.model, parts, chosen, true, scene.hiddenParts);
        if (shown)
            return loading_.warn(
                say("the sky that was modelled around it, {0}, lights it as an environment map; 'look sky' "
                    "shows it under another sky",
                    firstOf(names)));
        loading_.warn(
            say("the sky that was modelled around it, {0}, is hidden, since it would keep the light "
                "out; 'part show' or --show shows it",
                firstOf(names)));
    }

  private:
    /// The parts that are the skies around the model, one value for each; none where a part is more than
    /// that.
    std::vector<std::uint8_t> domesAmong(const std::vector<NamedPart>& parts) {
        const std::vector<std::uint32_t>& domes = loading_.surveyed().subject.domes;
        std::vector<std::uint8_t> chosen(parts.size());
        std::uint64_t triangles = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto holdsDome = [&](std::uint32_t piece) {
                const ModelPart& part = out_.scene.model.parts[piece];
                const auto next = std::ranges::lower_bound(domes, part.firstTriangle);
                return next != domes.end() && *next - part.firstTriangle < part.triangleCount;
            };
            if (std::none_of(parts[i].pieces.begin(), parts[i].pieces.end(), holdsDome)) continue;
            chosen[i] = 1;
            triangles += parts[i].triangles;
        }
        if (triangles != domes.size()) chosen.clear();
        return chosen;
    }

    /// The picture of the chosen parts, as an environment.
    bool showShell(const std::vector<NamedPart>& parts, const std::vector<std::uint8_t>& chosen) {
        Scene& scene = out_.scene;
        if (loading_.options.lighting.preset || loading_.options.lighting.environment || scene.sky)
            return false;
        EnvironmentFile described;
        described.kind = EnvironmentKind::Parts;
        std::vector<std::uint8_t> pieces(scene.model.parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (chosen[i] == 0) continue;
            if (parts[i].name.empty() || isPattern(parts[i].name)) return false; // no scene can name it
            described.parts.emplace_back(parts[i].name);
            for (const std::uint32_t piece : parts[i].pieces) pieces[piece] = 1;
        }
        auto picture = pictureOfShell(scene, out_.tree, pieces, described.parts.front());
        if (!picture) return false;
        scene.activeEnvironment = static_cast<int>(addEnvironment(scene, described, std::move(*picture)));
        return true;
    }

    Loading& loading_;
    LoadedScene& out_;
};

} // namespace

void hideDomes(Loading& loading) { ModelledSky(loading).hide(); }

} // namespace rtcore
