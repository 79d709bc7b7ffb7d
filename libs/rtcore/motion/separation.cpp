#include "rtcore/motion/separation.h"

#include <algorithm>
#include <limits>

namespace rtcore {

namespace {

/// The nearest pair of points found so far; the line stands in the origin.
struct Nearest {
    explicit Nearest(double lineHeight) : height(lineHeight) {}

    void offer(Vec3d onTriangle) { offer(onTriangle, {0, 0, std::clamp(onTriangle.z, 0.0, height)}); }
    void offer(Vec3d onTriangle, Vec3d onLine) {
        const Vec3d apart = onLine - onTriangle;
        const double d = dot(apart, apart);
        if (d >= square) return;
        square = d;
        onFace = inFace;
        point = onTriangle;
        difference = apart;
    }

    double height;
    double square = std::numeric_limits<double>::max();
    bool inFace = false, onFace = false;
    Vec3d point, difference;
};

double fraction(double part, double whole) { return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; }

void offerEdge(Nearest& nearest, Vec3d from, Vec3d to) {
    const Vec3d along = to - from;
    nearest.offer(from);
    // Beside the line, then at its two ends.
    nearest.offer(from + along * fraction(-(from.x * along.x + from.y * along.y),
                                          along.x * along.x + along.y * along.y));
    const double whole = dot(along, along);
    for (const Vec3d end : {Vec3d{}, Vec3d{0, 0, nearest.height}}) {
        nearest.offer(from + along * fraction(dot(end - from, along), whole), end);
    }
}

void offerFace(Nearest& nearest, Vec3d a, Vec3d b, Vec3d c, Vec3d normal) {
    const Vec3d ab = b - a, ac = c - a;
    const double square = dot(normal, normal);
    if (!(square > 0)) return;
    nearest.inFace = true;
    for (const Vec3d end : {Vec3d{}, Vec3d{0, 0, nearest.height}}) {
        const Vec3d from = end - a;
        const double w = dot(cross(ab, from), normal) / square;
        const double v = dot(cross(from, ac), normal) / square;
        if (v >= 0 && w >= 0 && v + w <= 1) nearest.offer(a + ab * v + ac * w, end);
    }
    // Where the line goes through.
    const double p = b.x * c.y - b.y * c.x, q = c.x * a.y - c.y * a.x, r = a.x * b.y - a.y * b.x;
    const bool inside = (p >= 0 && q >= 0 && r >= 0) || (p <= 0 && q <= 0 && r <= 0);
    const double sum = p + q + r;
    if (!inside || sum == 0) return;
    const double z = (p * a.z + q * b.z + r * c.z) / sum;
    if (z >= 0 && z <= nearest.height) nearest.offer({0, 0, z});
}

} // namespace

Separation separate(const UprightLine& line, const SolidTriangle& triangle) {
    const Vec3d a = triangle.a - line.foot, b = triangle.b - line.foot, c = triangle.c - line.foot;
    const Vec3d normal = cross(b - a, c - a);
    Nearest nearest(line.height);
    offerEdge(nearest, a, b);
    offerEdge(nearest, b, c);
    offerEdge(nearest, c, a);
    offerFace(nearest, a, b, c, normal);

    Separation result;
    result.distance = std::sqrt(nearest.square);
    result.onTriangle = nearest.point + line.foot;
    result.onFace = nearest.onFace;
    constexpr double kTouching = 1e-12;
    if (result.distance > kTouching) {
        result.normal = nearest.difference * (1 / result.distance);
        return result;
    }
    const Vec3d unit = normalize(normal);
    const double side = dot(Vec3d{0, 0, line.height / 2} - a, unit);
    result.normal = unit == Vec3d{} ? Vec3d{0, 0, 1} : side < 0 ? -unit : unit;
    return result;
}

} // namespace rtcore
