/// Measures that are kept with a scene: lengths, angles, areas and volumes, by the points between which they
/// were taken, and how their labels tell them.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/platform/sentence.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

enum class MeasureKind : std::uint8_t { Distance, Chain, Angle, Height, Area, Volume };
inline constexpr std::array<std::string_view, 6> kMeasureKinds{"distance", "chain", "angle",
                                                               "height",   "area",  "volume"};
inline std::string_view nameOf(MeasureKind kind) { return kMeasureKinds.at(static_cast<std::size_t>(kind)); }

inline constexpr std::size_t kMaxMeasures = 1000, kMaxChainPoints = 64;
inline constexpr std::size_t kMaxMeasureName = 200; ///< bytes

/// Points are in scene units from the scene's zero, in doubles, which keep the digits of what was typed.
struct KeptMeasure {
    MeasureKind kind = MeasureKind::Distance;
    /// Distance: 2. Chain: 3 to kMaxChainPoints. Angle: 3, at the second. Height: a point, and its foot on
    /// the floor. Area and volume: 1, where its label is.
    std::vector<Vec3d> points;
    Vec3 normal = {};   ///< of an area's face, of any length
    double amount = 0;  ///< of an area or a volume: square or cubic scene units, at most 1e36
    int part = 0;       ///< that a volume is of: its number in namedParts(), counted from 1
    std::string name{}; ///< may be "" ; UTF-8 of at most kMaxMeasureName bytes
    friend bool operator==(const KeptMeasure&, const KeptMeasure&) = default;
};

/// Units of lengths in labels; areas and volumes have their squares and cubes.
enum class LengthUnit : std::uint8_t { Metre, Centimetre, Millimetre, Foot, Inch };
inline constexpr std::array<std::string_view, 5> kLengthUnits{"m", "cm", "mm", "ft", "in"};
inline std::string_view nameOf(LengthUnit unit) { return kLengthUnits.at(static_cast<std::size_t>(unit)); }
/// Nothing where none is called so.
std::optional<LengthUnit> lengthUnitNamed(std::string_view name);

inline constexpr int kMaxMeasureDecimals = 6;

struct KeptMeasures {
    std::vector<KeptMeasure> all; ///< kMaxMeasures at most
    LengthUnit unit = LengthUnit::Metre;
    int decimals = 3; ///< of lengths, areas and volumes in labels: 0 to kMaxMeasureDecimals
    friend bool operator==(const KeptMeasures&, const KeptMeasures&) = default;
};

/// Why it cannot be kept: too few points or too many, points that are not finite or beyond 1e12, an angle
/// without sides, an amount below 0, a name that is too long or no UTF-8.
std::optional<Sentence> problemOf(const KeptMeasure& measure);

/// Value and unit as a label tells them.
struct MeasureValue {
    double value = 0;
    int power = 1;    ///< of the unit of length: 1, 2 or 3; 0: degrees
    int decimals = 0; ///< to show
    friend bool operator==(const MeasureValue&, const MeasureValue&) = default;
};
/// The whole of a chain. `style`: its unit and decimals.
MeasureValue valueOf(const KeptMeasure& measure, const KeptMeasures& style, double metresPerUnit);
/// The legs of a chain, one by one; of other kinds none.
std::vector<MeasureValue> legsOf(const KeptMeasure& measure, const KeptMeasures& style, double metresPerUnit);

/// "m", "m2", "m3", "degrees".
std::string unitText(const MeasureValue& value, LengthUnit unit);
/// "2.350 m".
std::string textOf(const MeasureValue& value, LengthUnit unit);

/// Where the label is: in the middle of a length, at the end of a chain, at the point of the others.
Vec3d labelPoint(const KeptMeasure& measure);

} // namespace rtcore
