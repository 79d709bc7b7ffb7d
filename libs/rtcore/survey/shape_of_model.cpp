#include "rtcore/survey/shape_of_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr int kBands = 64;
constexpr float kFlat = 0.99F;                     ///< cosine of the normal to the axis
constexpr double kContact = 0.01;                  ///< of the height: what touches the ground
constexpr std::size_t kSampledTriangles = 400'000; ///< about so many are looked at

/// Area by height.
struct Bands {
    std::array<double, kBands> all{}, up{}, down{};
    double base = 0, lid = 0, moment = 0, sum = 0;

    void add(double height, float cosine, double area) {
        const auto band = static_cast<std::size_t>(std::clamp(height * kBands, 0.0, kBands - 1.0));
        all.at(band) += area;
        moment += height * area;
        sum += area;
        if (cosine > kFlat) up.at(band) += area;
        if (cosine < -kFlat) down.at(band) += area;
        if (cosine < -kFlat && height < kContact) base += area;
        if (cosine > kFlat && height > 1 - kContact) lid += area;
    }

    double asymmetry() const {
        double difference = 0;
        for (std::size_t i = 0; i < kBands; ++i) difference += std::fabs(all.at(i) - all.at(kBands - 1 - i));
        return sum > 0 ? difference / (2 * sum) : 0;
    }
};

double largest(const std::array<double, kBands>& areas, int first, int last) {
    return *std::max_element(areas.begin() + first, areas.begin() + last);
}

} // namespace

ModelShape shapeOf(const Mesh& mesh) {
    ModelShape shape;
    Box3 bounds;
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle.v) bounds.extend(mesh.vertices[v].position());
    if (bounds.empty()) return shape;
    const Vec3 size = bounds.size();
    std::array<Bands, 3> bands;
    double flat = 0, all = 0;
    const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / kSampledTriangles);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
        const auto id = static_cast<std::uint32_t>(t);
        const Vec3 a = mesh.position(id, 0), b = mesh.position(id, 1), c = mesh.position(id, 2);
        const Vec3 normal = cross(b - a, c - a);
        const float doubled = length(normal);
        if (!(doubled > 0) || !std::isfinite(doubled)) continue;
        const Vec3 middle = (a + b + c) / 3;
        const double area = 0.5 * double{doubled};
        bool right = false;
        for (int axis = 0; axis < 3; ++axis) {
            const float cosine = normal[axis] / doubled;
            right = right || std::fabs(cosine) > kFlat;
            const double height =
                size[axis] > 0 ? double{(middle[axis] - bounds.lo[axis]) / size[axis]} : 0.5;
            bands.at(static_cast<std::size_t>(axis)).add(height, cosine, area);
        }
        all += area;
        if (right) flat += area;
    }
    shape.boxy = all > 0 ? flat / all : 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Bands& of = bands.at(static_cast<std::size_t>(axis));
        AxisShape& to = shape.axes[axis];
        to.low = bounds.lo[axis];
        to.high = bounds.hi[axis];
        to.footprint = double{size[(axis + 1) % 3]} * double{size[(axis + 2) % 3]};
        const double whole = to.footprint > 0 ? static_cast<double>(step) / to.footprint : 0;
        to.base = of.base * whole;
        to.lid = of.lid * whole;
        to.floor = largest(of.up, 0, kBands / 2) * whole;
        to.roof = largest(of.down, kBands / 2, kBands) * whole;
        to.asymmetry = of.asymmetry();
        to.centroid = of.sum > 0 ? of.moment / of.sum : 0.5;
    }
    return shape;
}

} // namespace rtcore
