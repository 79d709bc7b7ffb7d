#include "rtcore/survey/part_roles.h"

#include "rtcore/scene/name_words.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

namespace {

using std::string_view;

enum class Lies { Flat, Upright, Anyhow };
enum class Of { Anything, Buildings, Sky }; ///< cars have doors and windows, too

struct Role {
    Lies lies;
    Of of;
    std::array<string_view, 22> words;
};

constexpr Role kRoles[] = {
    {Lies::Flat, Of::Buildings, {"floor",    "floors",  "flooring",  "boden",   "fussboden", "plancher",
                                 "suelo",    "piso",    "pavimento", "podlaha", "podloga",   "vloer",
                                 "chao",     "parquet", "parkett",   "parket",  "parkety",   "parquete",
                                 "laminate", "carpet",  "teppich",   "koberec"}},
    {Lies::Flat,
     Of::Buildings,
     {"ceiling", "ceilings", "zimmerdecke", "plafond", "techo", "soffitto", "strop", "sufit", "teto"}},
    {Lies::Flat, Of::Anything, {"ground",   "terrain", "gelande", "grass", "gras",    "lawn",
                                "rasen",    "pelouse", "herbe",   "erba",  "cesped",  "trava",
                                "travnik",  "trawa",   "relva",   "road",  "strasse", "sidewalk",
                                "pavement", "asphalt", "asfalt",  "meadow"}},
    {Lies::Upright, Of::Buildings, {"wall",  "walls",   "wand",   "wande",  "mauer",  "mur",    "murs",
                                    "pared", "paredes", "muro",   "muri",   "parete", "zed",    "zdi",
                                    "stena", "steny",   "sciana", "parede", "muur",   "facade", "fassade"}},
    {Lies::Upright, Of::Anything, {"door",    "doors",    "tur",  "turen",  "porte",   "puerta",  "porta",
                                   "dvere",   "drzwi",    "deur", "window", "windows", "fenster", "fenetre",
                                   "ventana", "finestra", "okno", "okna",   "janela",  "raam"}},
    {Lies::Anyhow, Of::Buildings, {"stair",   "stairs",    "staircase", "steps",   "treppe",
                                   "stufen",  "escalier",  "escalera",  "schody",  "escada",
                                   "storey",  "stockwerk", "etage",     "balcony", "balkon",
                                   "chimney", "gable",     "giebel",    "attic",   "cellar"}},
    {Lies::Anyhow,
     Of::Sky,
     {"sky", "skies", "skybox", "skydome", "skysphere", "himmel", "ciel", "cielo", "nebe", "obloha", "niebo",
      "ceu", "hemel"}},
};

/// German writes compounds as one word, and so do many people in English: "Fussboden", "groundfloor".
bool means(string_view word, string_view known) {
    constexpr std::size_t kLong = 5;
    return word == known || (known.size() >= kLong && word.ends_with(known));
}

const Role* roleOf(string_view name) {
    for (const std::string& word : nameWords(name))
        for (const Role& role : kRoles)
            for (const string_view known : role.words)
                if (!known.empty() && means(word, known)) return &role;
    return nullptr;
}

/// The role of each triangle's part, or else of its material.
class Roles {
  public:
    explicit Roles(const Model& model) : model_(model) {
        for (const ModelPart& part : model.parts) parts_.push_back(roleOf(model.name(part.nameOffset)));
        for (const Material& material : model.materials)
            materials_.push_back(roleOf(model.name(material.nameOffset)));
    }
    bool any() const {
        const auto known = [](const Role* role) { return role != nullptr; };
        return std::ranges::any_of(parts_, known) || std::ranges::any_of(materials_, known);
    }
    /// `triangle` must not be below that of the last call.
    const Role* at(std::uint32_t triangle) {
        while (part_ < model_.parts.size() && end(model_.parts[part_]) <= triangle) ++part_;
        const bool inPart = part_ < model_.parts.size() && model_.parts[part_].firstTriangle <= triangle;
        if (inPart && parts_[part_] != nullptr) return parts_[part_];
        const std::uint32_t material = model_.mesh.shading[triangle].material;
        return material < materials_.size() ? materials_[material] : nullptr;
    }

  private:
    static std::uint64_t end(const ModelPart& part) {
        return std::uint64_t{part.firstTriangle} + part.triangleCount;
    }
    const Model& model_;
    std::vector<const Role*> parts_, materials_;
    std::size_t part_ = 0;
};

} // namespace

PartRoles partRoles(const Model& model) {
    PartRoles sum;
    const Mesh& mesh = model.mesh;
    Roles roles(model);
    if (!roles.any() || mesh.shading.size() != mesh.triangles.size()) return sum;
    std::array<bool, std::size(kRoles)> seen{};
    double all = 0, ground = 0, sky = 0;
    constexpr std::size_t kMax = 400'000;
    const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / kMax);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
        const auto id = static_cast<std::uint32_t>(t);
        const Role* const role = roles.at(id);
        const Vec3 a = mesh.position(id, 0);
        const Vec3 across = cross(mesh.position(id, 1) - a, mesh.position(id, 2) - a);
        const auto area = double{length(across)};
        if (!std::isfinite(area)) continue;
        all += area;
        if (role == nullptr) continue;
        if (role->lies == Lies::Flat && role->of == Of::Anything) ground += area;
        if (role->of == Of::Sky) sky += area;
        seen.at(static_cast<std::size_t>(role - kRoles)) = true;
        if (role->lies == Lies::Anyhow) continue;
        std::array<double, 3>& areas = role->lies == Lies::Flat ? sum.lying : sum.standing;
        for (int axis = 0; axis < 3; ++axis)
            areas.at(static_cast<std::size_t>(axis)) += 0.5 * std::fabs(double{across[axis]});
    }
    int ofBuildings = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
        ofBuildings += seen.at(i) && kRoles[i].of == Of::Buildings ? 1 : 0;
    sum.building = ofBuildings >= 2;
    constexpr double kMuchSky = 0.3; // not a picture of it on a wall
    sum.landscape = sky > kMuchSky * all || (!sum.building && ground > 0.5 * all);
    return sum;
}

} // namespace rtcore
