#include "rtcore/look/material_names.h"

#include "rtcore/scene/material_edit.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace rtcore {

namespace {

using std::string_view;

/// What a kind makes of the material's colour.
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
    {"glass",
     glass,
     {"glass", "glas", "verre", "vidrio", "vetro", "sklo", "szklo", "vidro", "glazing", "verglasung", "vitre",
      "cristal", "windowpane"}},
    {"water", water, {"water", "wasser", "eau", "agua", "acqua", "voda", "woda"}},
    {"mirror",
     mirrorOf,
     {"mirror", "spiegel", "miroir", "espejo", "specchio", "zrcadlo", "lustro", "espelho"}},
    {"chrome", chromeOf, {"chrome", "chrom", "cromo", "chroom"}},
    {"metal", metalOf, {"metal",  "metall", "steel",  "stahl",     "acier",    "acero", "acciaio", "ocel",
                        "stal",   "inox",   "staal",  "aluminium", "aluminum", "alu",   "hlinik",  "kov",
                        "silver", "silber", "argent", "plata",     "argento",  "zlato", "gold",    "oro",
                        "copper", "kupfer", "cuivre", "cobre",     "rame",     "brass", "messing", "laiton"}},
    {"polished", polishedOf, {"parquet", "parkett", "parket",    "parkety",   "parquete",   "laminate",
                              "laminat", "marble",  "marmor",    "marbre",    "marmol",     "marmo",
                              "mramor",  "marmur",  "granite",   "granit",    "tile",       "tiles",
                              "fliese",  "fliesen", "carrelage", "azulejo",   "piastrella", "dlazba",
                              "ceramic", "keramik", "keramika",  "porcelain", "porzellan",  "porcelan"}},
    {"lacquer", lacquerOf, {"lacquer", "lack", "laque", "laca", "lak", "varnish", "carpaint", "autolack"}},
};

/// The letters with a mark of these languages, by the second byte of their UTF-8, as plain ones; others stay.
char foldedLatin(unsigned char lead, unsigned char next) {
    const unsigned code = (lead & 0x1FU) << 6U | (next & 0x3FU);
    constexpr string_view kFrom =
        "\xE0\xE1\xE2\xE3\xE4\xE7\xE8\xE9\xEA\xEB\xEC\xED\xEE\xEF\xF1\xF2\xF3\xF4\xF5\xF6"
        "\xF9\xFA\xFB\xFC\xFD";
    constexpr string_view kTo = "aaaaaceeeeiiiinooooouuuuy";
    const unsigned lower = code >= 0xC0 && code <= 0xDE ? code + 0x20 : code;
    if (lower <= 0xFF) {
        const std::size_t at = kFrom.find(static_cast<char>(lower));
        if (at != string_view::npos) return kTo[at];
    }
    switch (code | 1U) { // Latin Extended-A has capitals before small letters, in pairs
    case 0x10D:
        return 'c';
    case 0x10F:
        return 'd';
    case 0x105:
        return 'a';
    case 0x107:
        return 'c';
    case 0x119:
        return 'e';
    case 0x11B:
        return 'e';
    case 0x159:
        return 'r';
    case 0x15B:
        return 's';
    case 0x161:
        return 's';
    case 0x165:
        return 't';
    case 0x16F:
        return 'u';
    default:
        break;
    }
    if (code == 0x141 || code == 0x142) return 'l';
    if (code == 0x143 || code == 0x144 || code == 0x147 || code == 0x148) return 'n';
    if (code >= 0x179 && code <= 0x17E) return 'z';
    return 0;
}

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }

/// In lower case and without marks; a capital after a small letter begins a word.
std::vector<std::string> wordsOf(string_view name) {
    std::vector<std::string> words(1);
    char before = 0;
    for (std::size_t i = 0; i < name.size(); ++i) {
        char c = name[i];
        const auto lead = static_cast<unsigned char>(c);
        if (lead >= 0xC0 && lead < 0xE0 && i + 1 < name.size())
            c = foldedLatin(lead, static_cast<unsigned char>(name[++i]));
        const bool letter = isUpper(c) || isLower(c);
        if ((!letter || (isUpper(c) && isLower(before))) && !words.back().empty()) words.emplace_back();
        if (letter) words.back() += static_cast<char>(isUpper(c) ? c - 'A' + 'a' : c);
        before = c;
    }
    return words;
}

/// What other words end with alone in compounds, which German writes as one: "Fensterglas", not "frame" for
/// rame.
constexpr std::array<string_view, 14> kCompounds{"glass",   "glas",    "wasser",  "spiegel", "stahl",
                                                 "metall",  "kupfer",  "silber",  "marmor",  "granit",
                                                 "fliesen", "parkett", "laminat", "chrom"};

bool means(string_view word, string_view known) {
    if (word == known) return true;
    const bool compound = std::ranges::find(kCompounds, known) != kCompounds.end();
    return compound && word.ends_with(known) && word != "douglas";
}

const Kind* kindNamed(string_view name) {
    for (const std::string& word : wordsOf(name))
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

std::string guessedText(std::span<const MaterialGuess> guesses) {
    if (guesses.empty()) return {};
    std::string kinds;
    for (const Kind& kind : kKinds) {
        const bool any = std::ranges::any_of(
            guesses, [&](const MaterialGuess& guess) { return string_view(guess.kind) == kind.name; });
        if (any) kinds += (kinds.empty() ? "" : ", ") + std::string(kind.name);
    }
    return fmt::format("{} {} guessed by name ({})", guesses.size(),
                       guesses.size() == 1 ? "material is" : "materials are", kinds);
}

} // namespace rtcore
