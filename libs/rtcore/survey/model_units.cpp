#include "rtcore/survey/model_units.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/exporter_habits.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/survey/part_roles.h"
#include "rtcore/survey/shape_of_model.h"
#include "rtcore/survey/survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

// Odds are natural logarithms, as in exporter_habits.h.

/// How much speaks for the axis to be up rather than horizontal.
double oddsOfUp(const AxisShape& axis, const AxisShape& other) {
    const double longer = double{std::max(axis.extent(), other.extent())};
    // Flat things lie: beds, trays, terrain.
    const double thin = longer > 0 ? double{axis.extent()} / longer : 1;
    double odds = thin < 0.25 ? 1.5 * (0.25 - thin) / 0.25 + 0.5 : 0;
    // Flat pieces lie: tops of tables, and more so what it stands on.
    odds += std::min(std::max(axis.base, axis.lid), 1.0);
    odds += std::clamp(axis.base - axis.lid, 0.0, 1.0);
    // Rooms have floors, while vaults and roofs are seldom one flat piece.
    odds += 1.0 * std::clamp(axis.floor - axis.roof, 0.0, 1.0);
    // Left and right are alike, often front and back; top and bottom are not.
    odds += 2.5 * axis.asymmetry;
    // It was put onto the ground, and not beside a wall.
    const double ground = std::fabs(double{axis.low}), extent = double{axis.extent()};
    if (ground <= 0.005 * extent) odds += 0.7;
    // The heavy part is below.
    odds += 1.0 * (0.5 - axis.centroid);
    return odds;
}

/// How much speaks for z to be up rather than y, by what its floors and walls are across.
double oddsOfNames(const PartRoles& roles) {
    const auto lead = [](const std::array<double, 3>& areas) {
        const double sum = areas[0] + areas[1] + areas[2];
        return sum > 0 ? (areas[2] - areas[1]) / sum : 0;
    };
    // Walls are across two axes.
    constexpr double kFloors = 4, kWalls = 4, kMax = 4;
    return std::clamp(kFloors * lead(roles.lying) - kWalls * lead(roles.standing), -kMax, kMax);
}

/// Sizes by which the unit is guessed; in scene units.
struct Sizes {
    double height = 0, longest = 0;
    double room = 0; ///< the height of its rooms, 0: none
    double boxy = 0; ///< of ModelShape
    bool building = false, landscape = false;
};

/// How much more likely things of that size are than others.
double oddsOfSize(const Sizes& size, double metres) {
    const auto outside = [metres](double units, double low, double high, double below, double above) {
        const double value = units * metres;
        if (value < low) return -below * std::log10(low / value);
        return value > high ? -above * std::log10(value / high) : 0.0;
    };
    constexpr double kTooSmall = 3, kTooLarge = 4;
    if (size.landscape) return outside(size.longest, 30, 20'000, kTooSmall, kTooLarge);
    // Houses have right angles, and so have cupboards; other things seldom are as large as a car.
    const bool hollow = size.room > 0 && !size.building;
    const double largest = size.boxy > 0.6 && !hollow ? 25 : 5;
    const double thing = outside(size.longest, 0.02, largest, kTooSmall, kTooLarge);
    if (!(size.room > 0) && !size.building) return thing;
    double house = outside(size.height, 2.2, 30, 9, 6);
    // Few rooms are as high as churches.
    if (size.room > 0)
        house = std::min(house, outside(size.room, 2, 30, 9, 6) + outside(size.room, 2, 6, 0, 1));
    // Without a name for it, what is hollow is an oven or a car rather than a higher one, or a round hall.
    if (hollow) {
        const double round = std::clamp(8 * (0.6 - size.boxy), 0.0, 3.0);
        house -= round * std::clamp((size.height * metres - 4) / 3, 0.0, 1.0);
        house += outside(size.room, 0, 18, 0, 8) + outside(size.longest, 0, 120, 0, 6);
    }
    // Else a hollow thing; of a building, a model of it.
    const double rarely = size.building ? -3 : -0.7;
    return std::max(house, thing + rarely);
}

struct Choice {
    std::size_t unit = 0;
    bool bySize = false; ///< against the habits
};

Choice chooseUnit(const OriginHabits& habits, const Sizes& size) {
    std::array<double, kLengthUnits> odds{};
    for (std::size_t i = 0; i < kLengthUnits; ++i)
        odds.at(i) = habits.units.at(i) + oddsOfSize(size, kMetresIn.at(i));
    Choice choice;
    choice.unit = static_cast<std::size_t>(std::max_element(odds.begin(), odds.end()) - odds.begin());
    const auto usual = std::max_element(habits.units.begin(), habits.units.end());
    choice.bySize = habits.units.at(choice.unit) < *usual;
    return choice;
}

void guessUp(ModelUnits& units, const OriginHabits& habits, const ModelShape& shape, const PartRoles& roles) {
    const AxisShape &y = shape.axes[1], &z = shape.axes[2];
    // A single flat piece may be a picture as well as a floor.
    constexpr float kPicture = 0.003F;
    const bool picture = std::min(y.extent(), z.extent()) < kPicture * std::max(y.extent(), z.extent());
    // Things on a wall look as if they lay: no shape is certain.
    constexpr double kMaxByShape = 3;
    const double byShape =
        picture ? 0 : std::clamp(oddsOfUp(z, y) - oddsOfUp(y, z), -kMaxByShape, kMaxByShape);
    const double byNames = oddsOfNames(roles);
    const double odds = habits.zUp + byShape + byNames;
    const bool zUp = odds > 0;
    units.up = zUp ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
    units.otherUp = zUp ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const bool usual = (habits.zUp > 0) == zUp;
    const bool named = (byNames > 0) == zUp && std::fabs(byNames) > std::fabs(byShape);
    units.upWhy = usual   ? say("usual for {0}", habits.name)
                  : named ? say("by its floors and walls")
                          : say("by its shape");
    constexpr double kDoubtful = 1;
    units.surprising = zUp || std::fabs(odds) < kDoubtful;
}

void guessUnit(ModelUnits& units, OriginHabits habits, const ModelShape& shape, const PartRoles& roles,
               const KdTree& tree, const Mesh& mesh) {
    const int axis = std::fabs(units.up.x) > 0.5F ? 0 : std::fabs(units.up.y) > 0.5F ? 1 : 2;
    Sizes size{.boxy = shape.boxy, .building = roles.building, .landscape = roles.landscape};
    for (const AxisShape& each : shape.axes) size.longest = std::max(size.longest, double{each.extent()});
    if (!(size.longest > 0) || !std::isfinite(size.longest)) return;
    size.height = std::max(double{shape.axes[axis].extent()}, 1e-6 * size.longest);
    // Models with z upwards, in a format that does not ask for it, come from CAD.
    const bool known = roles.building || roles.landscape;
    if (units.upSaid == Said::Guessed && axis == 2 && habits.zUp < 0 && !known)
        habits.units.at(static_cast<std::size_t>(LengthUnit::Millimetre)) += 2;
    size.room = double{roomHeight(tree, mesh, units.up)};
    const Choice choice = chooseUnit(habits, size);
    units.metresPerUnit = static_cast<float>(kMetresIn.at(choice.unit));
    units.unitWhy = choice.bySize ? say("by its size") : say("usual for {0}", habits.name);
}

} // namespace

ModelUnits guessModelUnits(const ModelOrigin& origin, const KdTree& tree, const Model& model) {
    ModelUnits units;
    const OriginHabits habits = habitsOf(origin);
    if (origin.up) {
        units.up = units.otherUp = *origin.up;
        units.upSaid = Said::ByFormat;
    }
    if (origin.metresPerUnit) {
        units.metresPerUnit = static_cast<float>(*origin.metresPerUnit);
        units.unitSaid = Said::ByFormat;
    }
    if (origin.up && origin.metresPerUnit) return units;
    const ModelShape shape = shapeOf(model.mesh);
    const PartRoles roles = partRoles(model);
    if (!origin.up) guessUp(units, habits, shape, roles);
    if (!origin.metresPerUnit) guessUnit(units, habits, shape, roles, tree, model.mesh);
    return units;
}

ModelUnits withUserSays(ModelUnits units, std::optional<Vec3> up, std::optional<double> metresPerUnit) {
    if (up) {
        units.up = units.otherUp = *up;
        units.upSaid = Said::ByUser;
        units.surprising = false;
    }
    if (metresPerUnit) {
        units.metresPerUnit = static_cast<float>(*metresPerUnit);
        units.unitSaid = Said::ByUser;
    }
    return units;
}

namespace {

Sentence reason(Said said, const Sentence& why) {
    switch (said) {
    case Said::Guessed:
        return why.empty() ? form("guessed") : say("guessed: {0}", why);
    case Said::ByFormat:
        return form("the file says so");
    case Said::ByScene:
        return form("the scene says so");
    case Said::ByUser:
        break;
    }
    return form("as you say");
}

} // namespace

Sentence describe(const ModelUnits& units) {
    return say("{0} is up ({1}); one unit is {2} m ({3})", axisName(units.up),
               reason(units.upSaid, units.upWhy), fmt::format("{:.4g}", units.metresPerUnit),
               reason(units.unitSaid, units.unitWhy));
}

} // namespace rtcore
