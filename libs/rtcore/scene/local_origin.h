/// Coordinates of a model that lies far from its file's zero, as on a national grid: floats there are too
/// coarse.
#pragma once

#include "rtcore/math/vec.h"

#include <array>
#include <limits>

namespace rtcore {

/// Three coordinates as a file has them, scene units.
using FilePoint = std::array<double, 3>;
inline FilePoint filePoint(Vec3 p) { return {double{p.x}, double{p.y}, double{p.z}}; }

/// Where the scene's own zero lies in the coordinates of the model's file: whole units, where the model is
/// not smaller than one. Everything is traced near zero; what people write and read are the file's
/// coordinates.
struct LocalOrigin {
    FilePoint at{};

    bool isZero() const { return at == FilePoint{}; }
    /// In the scene; rounded once. Beyond the largest float it is infinite.
    Vec3 local(const FilePoint& p) const;
    /// In the file, exact but for what is smaller than a thousandth of a millionth of `at`.
    FilePoint inFile(Vec3 p) const;
    friend bool operator==(const LocalOrigin&, const LocalOrigin&) = default;
};

/// Grows to bounds of points in double; those that are not finite do not count.
struct FileBounds {
    static constexpr double kNone = std::numeric_limits<double>::infinity();
    FilePoint lo{kNone, kNone, kNone}, hi{-kNone, -kNone, -kNone};

    bool empty() const { return lo[0] > hi[0]; }
    void extend(const FilePoint& p);
    void extend(Vec3 p) { extend(filePoint(p)); }
    void extend(const FileBounds& other);
    double size() const;     ///< the largest side
    double farthest() const; ///< the largest coordinate, without its sign
};

/// What a float can tell apart at that distance from zero.
double coarsenessAt(double distance);

/// The middle of the bounds where floats are coarser there than that part of their size, else zero.
LocalOrigin originOf(const FileBounds& bounds, double part);

} // namespace rtcore
