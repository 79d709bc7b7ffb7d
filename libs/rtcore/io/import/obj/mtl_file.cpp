#include "rtcore/io/import/obj/mtl_file.h"

#include "rtcore/io/import/inspection/exporter_notes.h"
#include "rtcore/io/import/materials/exporter_colours.h"
#include "rtcore/io/import/mesh/utf16_text.h"
#include "rtcore/io/import/obj/map_statement.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/io/import/text/statement_warning.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

using View = std::string_view;

/// Names of statements that say nothing that is seen here.
constexpr std::array kSilent{
    View("ka"), View("map_ka"), View("sharpness"), View("map_aat"),         View("illum_unit"),
    View("km"), View("map_km"), View("density"),   View("interpolatemode"), View("fresnel")};
/// Names of those that would be seen.
constexpr std::array kUnsupported{View("refl"),    View("map_refl"),  View("disp"),    View("map_disp"),
                                  View("decal"),   View("map_ns"),    View("map_pr"),  View("map_pm"),
                                  View("map_ps"),  View("map_pc"),    View("map_pcr"), View("map_rma"),
                                  View("map_orm"), View("map_aniso"), View("map_tf"),  View("map_tr")};
/// Names of those with a number that would be seen, unless it is 0.
constexpr std::array kUnsupportedFactors{View("ps"), View("pc"), View("pcr"), View("aniso"), View("anisor")};

template <std::size_t size>
bool isOneOf(const std::array<View, size>& names, View name) {
    return std::ranges::find(names, name) != names.end();
}

std::optional<MtlMap> mapOf(View keyword) {
    using Row = std::pair<View, MtlMap>;
    static constexpr std::array kRows{Row{"map_kd", MtlMap::Diffuse},  Row{"map_d", MtlMap::Opacity},
                                      Row{"map_kn", MtlMap::Normal},   Row{"norm", MtlMap::Normal},
                                      Row{"map_ke", MtlMap::Emission}, Row{"map_emissive", MtlMap::Emission},
                                      Row{"map_bump", MtlMap::Height}, Row{"bump", MtlMap::Height},
                                      Row{"map_ks", MtlMap::Specular}};
    for (const auto& [word, map] : kRows)
        if (keyword == word) return map;
    return std::nullopt;
}

float* numberIn(SourceMaterial& m, View keyword) {
    if (keyword == "ns") return &m.shininess;
    if (keyword == "ni") return &m.refraction;
    if (keyword == "pr") return &m.roughness;
    return nullptr;
}

Colour* colourIn(SourceMaterial& m, View keyword) {
    if (keyword == "kd") return &m.diffuse;
    if (keyword == "ks") return &m.specular;
    if (keyword == "ke") return &m.emission;
    if (keyword == "tf") return &m.transmission;
    return nullptr;
}

bool isAbsolute(View path) {
    return path.starts_with('/') || path.starts_with('\\') || path.substr(1).starts_with(':');
}

class MtlReader {
  public:
    MtlReader(View text, std::string folder, MtlMaterials& materials, std::vector<std::string>& unsupported)
        : text_(text), folder_(std::move(folder)), materials_(materials), unsupported_(unsupported) {}

    void read(OddStatements& odd) {
        while (!text_.atEnd()) {
            const std::uint64_t line = text_.lines() + 1;
            if (text_.hasWord() && text_.next() != '#') {
                const View keyword = text_.word();
                if (!readStatement(inSmallLetters(keyword), std::string(keyword))) odd.add(line, keyword);
                text_.endStatement();
            } else {
                text_.endLine();
            }
        }
    }
    /// Of the materials that it describes.
    void decode() {
        for (const std::uint32_t number : described_) decodeColours(materials_.all()[number].source);
    }

  private:
    /// `keyword` in small letters. False for a statement that is not understood.
    bool readStatement(const std::string& keyword, const std::string& spelled) {
        if (keyword == "newmtl") {
            const std::string name = text_.rest();
            material_ = materials_.numberOf(name.empty() ? "DefaultMaterial" : name);
            described_.insert(*material_);
            materials_.all()[*material_].isDescribed = true;
            return true;
        }
        if (isOneOf(kSilent, keyword)) return true;
        if (isOneOf(kUnsupported, keyword)) return leaveOut(spelled);
        if (isOneOf(kUnsupportedFactors, keyword)) {
            const auto factor = text_.number();
            if (factor && *factor != 0) leaveOut(spelled);
            return factor.has_value();
        }
        return material_ && readProperty(keyword, materials_.all()[*material_]);
    }

    bool leaveOut(const std::string& keyword) {
        if (std::ranges::find(unsupported_, keyword) == unsupported_.end()) unsupported_.push_back(keyword);
        return true;
    }

    bool readProperty(const std::string& keyword, MtlMaterial& material) {
        SourceMaterial& m = material.source;
        if (const auto map = mapOf(keyword)) return readMap(*map, material);
        if (Colour* const colour = colourIn(m, keyword)) return readColour(*colour);
        if (float* const number = numberIn(m, keyword)) return readNumber(*number);
        if (keyword == "d" || keyword == "tr") return readOpacity(keyword == "tr", m.opacity);
        if (keyword == "pm") {
            const bool good = readNumber(m.metallic);
            if (good) m.rules = MaterialRules::MetallicRoughness;
            return good;
        }
        if (keyword != "illum") return false;
        const auto number = text_.number();
        if (!number || !(*number >= 0 && *number <= 100)) return false;
        m.illumination = static_cast<int>(*number);
        m.unlit = m.illumination == 0;
        return true;
    }

    bool readNumber(float& to) {
        const auto number = text_.number();
        if (number) to = *number;
        return number.has_value();
    }

    /// One number is a grey.
    bool readColour(Colour& to) {
        const auto r = text_.number();
        if (!r) return false;
        Colour colour{*r, *r, *r};
        if (text_.hasWord() && text_.next() != '#') {
            const auto g = text_.number(), b = text_.number();
            if (!g || !b) return false;
            colour = {*r, *g, *b};
        }
        to = colour;
        return true;
    }

    bool readOpacity(bool opposite, float& to) {
        if (text_.hasWord() && text_.next() == '-' && text_.word() != "-halo") return false;
        const auto number = text_.number();
        if (number) to = opposite ? 1 - *number : *number;
        return number.has_value();
    }

    bool readMap(MtlMap which, MtlMaterial& material) {
        const MapStatement statement = mapStatementOf(text_.rest());
        if (statement.name.empty()) return false;
        SourceMap& map = material.map(which);
        map.name = isAbsolute(statement.name) ? statement.name : folder_ + statement.name;
        map.wrapU = map.wrapV = statement.clamped ? TextureWrap::ClampToEdge : TextureWrap::Repeat;
        material.layout(which) = statement.layout;
        if (which == MtlMap::Height) material.source.heightScale = statement.bump;
        if (which == MtlMap::Normal) material.source.normalScale = statement.bump;
        return true;
    }

    StatementText text_;
    std::string folder_;
    MtlMaterials& materials_;
    std::vector<std::string>& unsupported_;
    std::optional<std::uint32_t> material_; ///< that is described
    std::set<std::uint32_t> described_;
};

} // namespace

SourceMap& MtlMaterial::map(MtlMap which) {
    switch (which) {
    case MtlMap::Diffuse:
        return source.diffuseMap;
    case MtlMap::Opacity:
        return source.alphaMap;
    case MtlMap::Normal:
        return source.normalMap;
    case MtlMap::Emission:
        return source.emissionMap;
    case MtlMap::Height:
        return source.heightMap;
    case MtlMap::Specular:
        break;
    }
    return source.specularMap;
}

MtlMaterials::MtlMaterials() { numberOf("DefaultMaterial"); }

std::uint32_t MtlMaterials::numberOf(const std::string& name) {
    const auto next = static_cast<std::uint32_t>(materials_.size());
    const auto [entry, isNew] = numbers_.try_emplace(name, next);
    if (isNew) {
        MtlMaterial material;
        material.source.rules = MaterialRules::Wavefront;
        material.source.name = name;
        material.source.diffuse = kUnsetDiffuse;
        material.source.illumination = 1;
        material.source.alphaMode = AlphaMode::Blend;
        materials_.push_back(std::move(material));
    }
    return entry->second;
}

void readMtl(const std::filesystem::path& path, const std::string& folder, MtlMaterials& materials,
             std::vector<std::string>& unsupported, std::string_view exporter, ImportReport& report) {
    const FileBytes file = openFileBytes(path);
    std::string text =
        utf8OfUtf16(file.bytes)
            .value_or(std::string(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()));
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    text += '\n';
    OddStatements odd;
    MtlReader reader(text, folder, materials, unsupported);
    reader.read(odd);
    odd.warn(path, report);
    const std::string own = openingComments(text);
    const bool known = exporterColours(own) != nullptr;
    if (hasDisplayColours(known ? std::string_view(own) : exporter)) reader.decode();
}

} // namespace rtcore
