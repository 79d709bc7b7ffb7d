#include "rtcore/look/material_names.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/scene/name_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace rtcore {

namespace {

using std::string_view;

/// The material of a kind in the material's own colour.
MaterialOverride glass() {
    MaterialOverride change;
    change.diffuse = Colour{};
    change.opacity = 0.0F;
    change.fresnel = true;
    change.transmission = Colour{0.95F, 0.97F, 0.96F};
    change.indexOfRefraction = 1.5F;
    return change;
}
MaterialOverride water() {
    MaterialOverride change = glass();
    change.transmission = Colour{0.7F, 0.85F, 0.88F};
    change.indexOfRefraction = 1.33F;
    return change;
}
MaterialOverride metal(float roughness, std::optional<Colour> colour = {}) {
    MaterialOverride change;
    change.diffuse = colour;
    change.roughness = roughness;
    change.metallic = 1.0F;
    return change;
}
MaterialOverride coated(float roughness) {
    MaterialOverride change;
    change.roughness = roughness;
    change.metallic = 0.0F;
    return change;
}

MaterialOverride mirrorOf() { return metal(0, kWhite * 0.92F); }
MaterialOverride chromeOf() { return metal(0.05F, Colour{0.62F, 0.63F, 0.64F}); }
MaterialOverride metalOf() { return metal(0.3F); }
MaterialOverride polishedOf() { return coated(0.25F); }
MaterialOverride lacquerOf() { return coated(0.1F); }

struct Kind {
    const char* name;
    MaterialOverride (*change)();
    std::array<string_view, 32> words; ///< lower case, as they are folded
};

constexpr Kind kKinds[] = {
    {form("glass"),
     glass,
     {"glass", "glas", "verre", "vidrio", "vetro", "sklo", "szklo", "vidro", "glazing", "verglasung", "vitre",
      "cristal", "windowpane"}},
    {form("water"), water, {"water", "wasser", "eau", "agua", "acqua", "voda", "woda"}},
    {form("mirror"),
     mirrorOf,
     {"mirror", "spiegel", "miroir", "espejo", "specchio", "zrcadlo", "lustro", "espelho"}},
    {form("chrome"), chromeOf, {"chrome", "chrom", "cromo", "chroom"}},
    {form("metal"), metalOf, {"metal",  "metall", "steel",   "stahl",  "acier",     "acero",    "acciaio",
                              "ocel",   "stal",   "inox",    "staal",  "aluminium", "aluminum", "alu",
                              "hlinik", "kov",    "silver",  "silber", "argent",    "plata",    "argento",
                              "zlato",  "gold",   "oro",     "copper", "kupfer",    "cuivre",   "cobre",
                              "rame",   "brass",  "messing", "laiton"}},
    {form("polished"),
     polishedOf,
     {"parquet", "parkett", "parket",   "parkety",   "parquete",  "laminate", "laminat",    "marble",
      "marmor",  "marbre",  "marmol",   "marmo",     "mramor",    "marmur",   "granite",    "granit",
      "tile",    "tiles",   "fliese",   "fliesen",   "carrelage", "azulejo",  "piastrella", "dlazba",
      "ceramic", "keramik", "keramika", "porcelain", "porzellan", "porcelan"}},
    {form("lacquer"),
     lacquerOf,
     {"lacquer", "lack", "laque", "laca", "lak", "varnish", "carpaint", "autolack"}},
};

/// Words that also count at the end of compounds, which German writes as one word: "Fensterglas", but not
/// "frame" for rame.
constexpr std::array<string_view, 14> kCompounds{"glass",   "glas",    "wasser",  "spiegel", "stahl",
                                                 "metall",  "kupfer",  "silber",  "marmor",  "granit",
                                                 "fliesen", "parkett", "laminat", "chrom"};

bool means(string_view word, string_view known) {
    if (word == known) return true;
    const bool compound = std::ranges::find(kCompounds, known) != kCompounds.end();
    return compound && word.ends_with(known) && word != "douglas";
}

const Kind* kindNamed(string_view name) {
    for (const std::string& word : nameWords(name))
        for (const Kind& kind : kKinds)
            for (const string_view known : kind.words)
                if (!known.empty() && means(word, known)) return &kind;
    return nullptr;
}

/// But for its roughness, or shine, which exporters give to all alike.
bool hasColourAlone(const Material& m) {
    const bool textured = m.diffuseTexture != kNoTexture || m.alphaTexture != kNoTexture ||
                          m.normalTexture != kNoTexture || m.emissionTexture != kNoTexture ||
                          m.metallicRoughnessTexture != kNoTexture || m.specularTexture != kNoTexture ||
                          m.transmissionTexture != kNoTexture;
    const bool mirrors = !hasRoughness(m) && !isBlack(m.mirror);
    return !textured && !mirrors && m.opacity == 1 && m.metallic == 0 && isBlack(m.emission) &&
           m.vertexAlpha == 0;
}

} // namespace

std::vector<MaterialGuess> guessMaterials(const Scene& scene) {
    const std::vector<Material>& all = scene.materials;
    const bool plain = std::ranges::all_of(all, [&](const Material& m) {
        return hasColourAlone(m) && m.roughness == all.front().roughness &&
               m.shininess == all.front().shininess;
    });
    std::vector<MaterialGuess> guesses;
    if (!plain) return guesses;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Kind* const kind = kindNamed(scene.model.name(all[i].nameOffset));
        if (kind == nullptr) continue;
        guesses.push_back({kind->change(), kind->name});
        guesses.back().change.number = static_cast<int>(i) + 1;
    }
    return guesses;
}

void useGuesses(Scene& scene, std::span<const MaterialGuess> guesses) {
    if (guesses.empty()) return;
    const std::vector<Material> files = scene.materials;
    for (const MaterialGuess& guess : guesses)
        editMaterial(scene, files, static_cast<std::size_t>(*guess.change.number) - 1, guess.change);
    closeSurfaces(scene, files);
}

Sentence guessedText(std::span<const MaterialGuess> guesses) {
    if (guesses.empty()) return {};
    std::optional<Sentence> kinds;
    for (const Kind& kind : kKinds) {
        const bool any = std::ranges::any_of(
            guesses, [&](const MaterialGuess& guess) { return string_view(guess.kind) == kind.name; });
        if (any) kinds = kinds ? say("{0}, {1}", *kinds, kind.name) : Sentence(kind.name);
    }
    return say(guesses.size() == 1 ? "{0} material is guessed by name ({1})"
                                   : "{0} materials are guessed by name ({1})",
               guesses.size(), kinds.value_or(Sentence()));
}

} // namespace rtcore
