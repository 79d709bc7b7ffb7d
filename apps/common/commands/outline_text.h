/// The answer to `plan outline`: the lines of a small plan, for the server and the programs that show one.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Positions are whole numbers of steps, to the right and up from the lower left corner. Lengths are units of
/// the model's file, whatever a unit is.
struct ToldOutline {
    using Line = std::vector<std::array<int, 2>>;

    int storey = 0; ///< from 1, the lowest; 0: the model has none, and the lines are contours
    std::vector<double> floors = {};             ///< of all storeys, along the up axis, the lowest first
    double top = 0;                              ///< of the model, in the same way
    double eyeHeight = 0;                        ///< above a floor; 0 without storeys
    std::array<double, 3> corner{};              ///< on the floor, in the coordinates of the model's file
    std::array<float, 3> right{}, ahead{}, up{}; ///< in the same, of unit length; `up` is the up axis
    double step = 1;                             ///< above 0
    std::array<int, 2> size{};                   ///< steps; 0 by 0 where nothing is cut
    std::vector<Line> solids = {}; ///< outlines of what is cut, filled by the even-odd rule; they close
    std::vector<Line> lines = {};  ///< along which open parts are cut
    std::vector<Line> light = {};  ///< of what is lower

    friend bool operator==(const ToldOutline&, const ToldOutline&) = default;
};

/// The number of the storey for an eye at that height: the highest whose floor is below it; the lowest where
/// none is, or where the eye is above the model. 0 where there are no storeys.
int storeyAt(const std::vector<double>& floors, double top, double eye);

std::string formatOutline(const ToldOutline& outline);

/// Throws rtcore::FileError BadData.
ToldOutline parseOutline(std::string_view text);

} // namespace app
