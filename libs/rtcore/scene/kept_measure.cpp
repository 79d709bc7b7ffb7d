#include "rtcore/scene/kept_measure.h"

#include "rtcore/settings/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rtcore {

namespace {

struct PointCount {
    std::size_t min, max;
};

constexpr std::array<PointCount, kMeasureKinds.size()> kPoints{
    {{2, 2}, {3, kMaxChainPoints}, {3, 3}, {2, 2}, {1, 1}, {1, 1}}};

PointCount pointsOf(MeasureKind kind) { return kPoints.at(static_cast<std::size_t>(kind)); }

bool isNear(Vec3d p) {
    constexpr double kFarthest = 1e12;
    return std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest && std::fabs(p.z) <= kFarthest;
}

std::optional<Sentence> problemOfPoints(const KeptMeasure& measure) {
    const std::vector<Vec3d>& points = measure.points;
    const auto [min, max] = pointsOf(measure.kind);
    if (points.size() < min || points.size() > max)
        return min == max
                   ? say("{0} has {1} points, not {2}", nameOf(measure.kind), min, points.size())
                   : say("{0} has {1} to {2} points, not {3}", nameOf(measure.kind), min, max, points.size());
    if (!std::ranges::all_of(points, isNear))
        return say("a point of the measure has a coordinate beyond 1e12; give one near the model");
    const bool sides =
        measure.kind != MeasureKind::Angle || (points[0] != points[1] && points[2] != points[1]);
    if (!sides) return say("an angle needs two points beside the one that it is at");
    return std::nullopt;
}

double metresOf(LengthUnit unit) {
    constexpr std::array<double, kLengthUnits.size()> kMetres{1, 0.01, 0.001, 0.3048, 0.0254};
    return kMetres.at(static_cast<std::size_t>(unit));
}

double angleOf(const std::vector<Vec3d>& points) {
    const Vec3d a = points[0] - points[1], b = points[2] - points[1];
    return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

double lengthOf(const std::vector<Vec3d>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
    return sum;
}

int powerOf(MeasureKind kind) {
    constexpr std::array<int, kMeasureKinds.size()> kPowers{1, 1, 0, 1, 2, 3};
    return kPowers.at(static_cast<std::size_t>(kind));
}

} // namespace

std::optional<LengthUnit> lengthUnitNamed(std::string_view name) {
    const auto* const at = std::ranges::find(kLengthUnits, name);
    if (at == kLengthUnits.end()) return std::nullopt;
    return static_cast<LengthUnit>(at - kLengthUnits.begin());
}

std::optional<Sentence> problemOf(const KeptMeasure& measure) {
    constexpr double kMaxAmount = 1e36;
    if (auto problem = problemOfPoints(measure)) return problem;
    if (!(measure.amount >= 0 && measure.amount <= kMaxAmount))
        return say("the area or volume of a measure is a number from 0 to 1e36");
    if (measure.kind == MeasureKind::Area && normalize(measure.normal) == Vec3{})
        return say("the normal of the measure is zero or too large");
    if (measure.kind == MeasureKind::Volume && measure.part < 1)
        return say("the part of a measure is a number from 1");
    if (measure.name.size() > kMaxMeasureName || findInvalidUtf8(measure.name) != std::string_view::npos)
        return say("the name of a measure is UTF-8 of at most {0} bytes", kMaxMeasureName);
    return std::nullopt;
}

MeasureValue valueOf(const KeptMeasure& measure, const KeptMeasures& style, double metresPerUnit) {
    constexpr int kAngleDecimals = 1;
    const int power = powerOf(measure.kind);
    if (power == 0) return {angleOf(measure.points), power, kAngleDecimals};
    const double size = power == 1 ? lengthOf(measure.points) : measure.amount;
    return {size * std::pow(metresPerUnit / metresOf(style.unit), power), power, style.decimals};
}

std::vector<MeasureValue> legsOf(const KeptMeasure& measure, const KeptMeasures& style,
                                 double metresPerUnit) {
    std::vector<MeasureValue> legs;
    if (measure.kind != MeasureKind::Chain) return legs;
    for (std::size_t i = 1; i < measure.points.size(); ++i)
        legs.push_back(
            {length(measure.points[i] - measure.points[i - 1]) * metresPerUnit / metresOf(style.unit), 1,
             style.decimals});
    return legs;
}

std::string unitText(const MeasureValue& value, LengthUnit unit) {
    if (value.power == 0) return "degrees";
    const std::string name(nameOf(unit));
    return value.power == 1 ? name : name + std::to_string(value.power);
}

std::string textOf(const MeasureValue& value, LengthUnit unit) {
    return fmt::format("{:.{}f} {}", value.value, value.decimals, unitText(value, unit));
}

Vec3d labelPoint(const KeptMeasure& measure) {
    switch (measure.kind) {
    case MeasureKind::Distance:
    case MeasureKind::Height:
        return (measure.points[0] + measure.points[1]) * 0.5;
    case MeasureKind::Chain:
        return measure.points.back();
    case MeasureKind::Angle:
        return measure.points[1];
    case MeasureKind::Area:
    case MeasureKind::Volume:
        break;
    }
    return measure.points[0];
}

} // namespace rtcore
