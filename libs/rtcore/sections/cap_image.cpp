#include "rtcore/sections/cap_image.h"

#include "rtcore/render/camera_rays.h"
#include "rtcore/sections/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace rtcore {

namespace {

using Codes = std::array<float, 3>;

/// Points of one plane in pixels of an image from its row `top` on.
class FlatView {
  public:
    FlatView(const CutPlane& plane, const CameraRays& rays, int top)
        : plane_(plane), top_(top), eye_(exact(rays.eye())), right_(exact(rays.plane().right)),
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
        return {dot(seen, right_) / dot(right_, right_), dot(seen, down_) / dot(down_, down_) - top_};
    }

    CutPlane plane_;
    double top_;
    Vec3d eye_, right_, down_, corner_;
    bool parallel_, facing_;
    Vec3d axis_;
    double nearest_ = 0;
};

Codes codesOf(Colour linear) {
    const auto code = [](float light) { return 255 * srgbEncode(std::clamp(light, 0.0F, 1.0F)); };
    return {code(linear.r), code(linear.g), code(linear.b)};
}

/// Of straight alpha. (Porter and Duff 1984, over)
void blend(Rgba8& pixel, const Codes& over, float part) {
    if (!(part > 0)) return;
    const float below = static_cast<float>(pixel.a) / 255;
    const float alpha = pixel.a == 255 ? 1 : part + below * (1 - part);
    const float weight = part / alpha;
    const auto mixed = [&](std::uint8_t code, float to) {
        return static_cast<std::uint8_t>(
            std::lround(static_cast<float>(code) + (to - static_cast<float>(code)) * weight));
    };
    pixel = {mixed(pixel.r, over[0]), mixed(pixel.g, over[1]), mixed(pixel.b, over[2]),
             static_cast<std::uint8_t>(std::lround(255 * alpha))};
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

/// Of a shape, and of its edges.
struct CapCodes {
    Codes area, edge;

    explicit CapCodes(Colour linear) : area(codesOf(linear)) {
        constexpr float kDark = 0.2F;
        for (std::size_t c = 0; c < area.size(); ++c) edge[c] = area[c] * kDark;
    }
};

/// The rows of an image from `top` on that `coverage` has.
struct CapBand {
    LdrImage& image;
    int top;
    Coverage& coverage;

    void paint(const CapShape& shape, const FlatView& view, const CapCodes& codes, bool hatched) const {
        constexpr double kEdge = 1.5; // pixels
        for (const FlatLoop& loop : shape.loops) coverage.add(view.pixels(loop));
        coverage.take([&](int x, int y, float part) {
            Rgba8& pixel = image.at(x, top + y);
            blend(pixel, codes.area, part);
            if (hatched) blend(pixel, codes.edge, part * hatchAt(x, top + y));
        });
        for (const FlatLine& edge : shape.edges) {
            const FlatLoop seen = view.pixels({edge.a, edge.b});
            if (seen.size() > 1) addLine(seen[0], seen[1], kEdge, coverage);
        }
        coverage.take([&](int x, int y, float part) { blend(image.at(x, top + y), codes.edge, part); });
    }
};

} // namespace

void paintCaps(const SectionCaps& caps, const CapStyle& style, std::span<const Colour> colours,
               const Camera& camera, LdrImage& image) {
    if (caps.empty() || style.colours == CapColours::None || image.pixels.empty()) return;
    constexpr int kPixelsAtOnce = 1 << 24; // of 4 bytes
    const int rows = std::max(kPixelsAtOnce / image.width, 1);
    const CameraRays rays(camera, image.width, image.height);
    for (int top = 0; top < image.height; top += rows) {
        Coverage coverage(image.width, std::min(rows, image.height - top));
        const CapBand band{image, top, coverage};
        for (const PlaneCaps& cut : caps.planes) {
            const FlatView view(cut.plane, rays, top);
            if (!view.facing()) continue;
            for (const CapShape& shape : cut.shapes) {
                const bool own = style.colours == CapColours::Own;
                band.paint(shape, view, CapCodes(own ? colours[shape.material] : style.colour),
                           style.hatched);
            }
        }
    }
}

} // namespace rtcore
