#include "rtcore/sections/cap_image.h"

#include "rtcore/render/camera_rays.h"
#include "rtcore/sections/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace rtcore {

namespace {

using Codes = std::array<float, 3>;

/// Points of one plane in pixels of an image.
class FlatView {
  public:
    FlatView(const CutPlane& plane, const CameraRays& rays)
        : plane_(plane), eye_(exact(rays.eye())), right_(exact(rays.plane().right)),
          down_(exact(rays.plane().down)), corner_(exact(rays.plane().corner)), parallel_(rays.parallel()),
          facing_(parallel_ ? dot(plane.normal, exact(rays.forward())) < 0 : plane.above(eye_) > 0),
          axis_(exact(rays.forward())) {
        // What is nearer along the view is not within the image.
        nearest_ = plane.above(eye_) / (2 * length(corner_));
    }

    /// Whether the camera looks at the side that was taken away.
    bool facing() const { return facing_; }

    /// The part of a loop that lies before the eye.
    FlatLoop pixels(const FlatLoop& loop) const {
        FlatLoop seen;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3d p = plane_.point(loop[i]) - eye_,
                        q = plane_.point(loop[(i + 1) % loop.size()]) - eye_;
            if (parallel_) {
                seen.push_back(pixel(p));
                continue;
            }
            const double a = dot(axis_, p) - nearest_, b = dot(axis_, q) - nearest_;
            if (a > 0) seen.push_back(pixel(p));
            if ((a > 0) != (b > 0)) seen.push_back(pixel(p + (q - p) * (a / (a - b))));
        }
        return seen;
    }

  private:
    /// `p` from the eye.
    FlatPoint pixel(Vec3d p) const {
        const Vec3d seen = (parallel_ ? p : p * (1 / dot(axis_, p))) - corner_;
        return {dot(seen, right_) / dot(right_, right_), dot(seen, down_) / dot(down_, down_)};
    }

    CutPlane plane_;
    Vec3d eye_, right_, down_, corner_;
    bool parallel_, facing_;
    Vec3d axis_;
    double nearest_ = 0;
};

Codes codesOf(Colour linear) {
    const auto code = [](float light) { return 255 * srgbEncode(std::clamp(light, 0.0F, 1.0F)); };
    return {code(linear.r), code(linear.g), code(linear.b)};
}

void blend(Rgba8& pixel, const Codes& over, float part) {
    const auto mixed = [&](std::uint8_t code, float to) {
        return static_cast<std::uint8_t>(
            std::lround(static_cast<float>(code) + (to - static_cast<float>(code)) * part));
    };
    pixel = {mixed(pixel.r, over[0]), mixed(pixel.g, over[1]), mixed(pixel.b, over[2]), pixel.a};
}

/// Of a hatching at 45 degrees, how dark it is at a pixel, 0..1.
float hatchAt(int x, int y) {
    constexpr int kPeriod = 8;
    constexpr std::array<float, kPeriod> kLine{0.25F, 0.75F, 0.25F};
    return kLine[static_cast<std::size_t>((x + y) % kPeriod)];
}

/// A line of that width, and as much longer.
void addLine(const FlatPoint& a, const FlatPoint& b, double width, Coverage& coverage) {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (!(length > 0)) return;
    const double x = (b[0] - a[0]) / length * width / 2, y = (b[1] - a[1]) / length * width / 2;
    const std::array<FlatPoint, 4> around{FlatPoint{a[0] - x + y, a[1] - y - x},
                                          {b[0] + x + y, b[1] + y - x},
                                          {b[0] + x - y, b[1] + y + x},
                                          {a[0] - x - y, a[1] - y + x}};
    coverage.add(around);
}

} // namespace

void paintCaps(const SectionCaps& caps, const CapStyle& style, std::span<const Material> materials,
               const Camera& camera, LdrImage& image) {
    if (caps.empty() || style.colours == CapColours::None || image.pixels.empty()) return;
    constexpr double kEdge = 1.5; // pixels
    constexpr float kDark = 0.2F; // of the shape's colour
    const CameraRays rays(camera, image.width, image.height);
    Coverage coverage(image.width, image.height);
    for (const PlaneCaps& cut : caps.planes) {
        const FlatView view(cut.plane, rays);
        if (!view.facing()) continue;
        for (const CapShape& shape : cut.shapes) {
            const Codes codes =
                codesOf(style.colours == CapColours::One ? style.colour : materials[shape.material].diffuse);
            const Codes dark{codes[0] * kDark, codes[1] * kDark, codes[2] * kDark};
            for (const FlatLoop& loop : shape.loops) coverage.add(view.pixels(loop));
            coverage.take([&](int x, int y, float part) {
                blend(image.at(x, y), codes, part);
                if (style.hatched) blend(image.at(x, y), dark, part * hatchAt(x, y));
            });
            for (const FlatLine& edge : shape.edges) {
                const FlatLoop seen = view.pixels({edge.a, edge.b});
                if (seen.size() > 1) addLine(seen[0], seen[1], kEdge, coverage);
            }
            coverage.take([&](int x, int y, float part) { blend(image.at(x, y), dark, part); });
        }
    }
}

} // namespace rtcore
