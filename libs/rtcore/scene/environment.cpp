#include "rtcore/scene/environment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace rtcore {
namespace {

constexpr double kExactPi = std::numbers::pi;

struct FacePoint {
    int face;
    double s, t;
};

// Cube maps are left-handed: z points ahead in them where x points to the right. Here ahead is -z, so that a
// face is seen as its image shows it, and as it lies in an equirectangular image.
// In double: the centre of a border texel lies 1/(n+1) of a texel from its neighbour's edge, less than a
// float resolves on large faces.
FacePoint facePoint(double x, double y, double behind) {
    const double z = -behind;
    const double ax = std::fabs(x), ay = std::fabs(y), az = std::fabs(z);
    int face = 0;
    double sc = 0, tc = 0, major = 0;
    if (ax >= ay && ax >= az) {
        face = x >= 0 ? 0 : 1;
        sc = x >= 0 ? -z : z;
        tc = -y;
        major = ax;
    } else if (ay >= az) {
        face = y >= 0 ? 2 : 3;
        sc = x;
        tc = y >= 0 ? z : -z;
        major = ay;
    } else {
        face = z >= 0 ? 4 : 5;
        sc = z >= 0 ? x : -x;
        tc = -y;
        major = az;
    }
    return {face, 0.5 * (sc / major + 1), 0.5 * (tc / major + 1)};
}

Vec3d faceDirection(int face, double s, double t) {
    const double sc = 2 * s - 1, tc = 2 * t - 1;
    switch (face) {
    case 0:
        return {1, -tc, sc};
    case 1:
        return {-1, -tc, -sc};
    case 2:
        return {sc, 1, -tc};
    case 3:
        return {sc, -1, tc};
    case 4:
        return {sc, -tc, -1};
    default:
        return {-sc, -tc, 1};
    }
}

int texelOf(double coordinate, int n) { return std::clamp(static_cast<int>(coordinate * n), 0, n - 1); }

/// The colour for a texel outside of the face: that of the texel at which its centre's direction points.
Colour neighbour(const std::array<HdrImage, 6>& faces, int face, int x, int y) {
    const int n = faces[0].width;
    const Vec3d d = faceDirection(face, (x + 0.5) / n, (y + 0.5) / n);
    const FacePoint p = facePoint(d.x, d.y, d.z);
    return faces[static_cast<std::size_t>(p.face)].at(texelOf(p.s, n), texelOf(p.t, n));
}

/// `image` in the middle of an image that is one texel larger on each side.
HdrImage withRoomForBorder(const HdrImage& image) {
    HdrImage padded(image.width + 2, image.height + 2);
    for (int y = 0; y < image.height; ++y) {
        const Colour* row = &image.at(0, y);
        std::copy(row, row + image.width, &padded.at(1, y + 1));
    }
    return padded;
}

HdrImage borderedFace(const std::array<HdrImage, 6>& faces, int face) {
    const int n = faces[0].width;
    HdrImage padded = withRoomForBorder(faces[static_cast<std::size_t>(face)]);
    for (int i = 0; i < n; ++i) {
        padded.at(i + 1, 0) = neighbour(faces, face, i, -1);
        padded.at(i + 1, n + 1) = neighbour(faces, face, i, n);
        padded.at(0, i + 1) = neighbour(faces, face, -1, i);
        padded.at(n + 1, i + 1) = neighbour(faces, face, n, i);
    }
    // Three faces meet at a corner, and each of them sees the mean of their corner texels there.
    for (const int y : {0, n + 1}) {
        for (const int x : {0, n + 1}) {
            const int insideX = std::clamp(x, 1, n), insideY = std::clamp(y, 1, n);
            const Colour sum = padded.at(insideX, insideY) + padded.at(x, insideY) + padded.at(insideX, y);
            padded.at(x, y) = sum / 3.0F;
        }
    }
    return padded;
}

Colour meanOfRow(const HdrImage& image, int y) {
    double r = 0, g = 0, b = 0;
    for (int x = 0; x < image.width; ++x) {
        const Colour c = image.at(x, y);
        r += c.r;
        g += c.g;
        b += c.b;
    }
    const double n = image.width;
    return {static_cast<float>(r / n), static_cast<float>(g / n), static_cast<float>(b / n)};
}

HdrImage borderedEquirectangular(const HdrImage& image) {
    const int w = image.width, h = image.height;
    HdrImage padded = withRoomForBorder(image);
    // Mirrored at the mean, so that every longitude reaches the mean of the outermost row exactly at the
    // pole.
    const Colour top = meanOfRow(image, 0), bottom = meanOfRow(image, h - 1);
    for (int x = 0; x < w; ++x) {
        padded.at(x + 1, 0) = 2.0F * top - image.at(x, 0);
        padded.at(x + 1, h + 1) = 2.0F * bottom - image.at(x, h - 1);
    }
    for (int y = 0; y < h + 2; ++y) {
        padded.at(0, y) = padded.at(w, y);
        padded.at(w + 1, y) = padded.at(1, y);
    }
    return padded;
}

/// x and y in texels of the image without its border, whose first texel has its centre at 0.5.
Colour bilinear(const HdrImage& padded, float x, float y) {
    const float left = std::clamp(x + 0.5F, 0.0F, static_cast<float>(padded.width - 1));
    const float top = std::clamp(y + 0.5F, 0.0F, static_cast<float>(padded.height - 1));
    const int x0 = std::min(static_cast<int>(left), padded.width - 2);
    const int y0 = std::min(static_cast<int>(top), padded.height - 2);
    const float fx = left - static_cast<float>(x0), fy = top - static_cast<float>(y0);
    const Colour upper = padded.at(x0, y0) * (1 - fx) + padded.at(x0 + 1, y0) * fx;
    const Colour lower = padded.at(x0, y0 + 1) * (1 - fx) + padded.at(x0 + 1, y0 + 1) * fx;
    return upper * (1 - fy) + lower * fy;
}

Colour sample(const HdrImage& padded, float u, float v, TexelFilter filter) {
    const int w = padded.width - 2, h = padded.height - 2;
    if (filter == TexelFilter::Nearest) {
        return padded.at(texelOf(u, w) + 1, texelOf(v, h) + 1);
    }
    return bilinear(padded, u * static_cast<float>(w), v * static_cast<float>(h));
}

/// One axis of an image, cut into cells of several texels each, or into several cells for each texel.
struct Cells {
    int texels, count;

    Cells(int size, int min) : texels(size), count(size >= min ? min : size * ((min + size - 1) / size)) {}
    bool finer() const { return count > texels; }
    /// The first texel of a cell that is not finer.
    int first(int i) const { return static_cast<int>(std::int64_t{i} * texels / count); }
    /// 0..1: where in the image a cell begins; i <= count.
    double start(int i) const {
        return finer() ? static_cast<double>(i) / count : static_cast<double>(first(i)) / texels;
    }
    double middle(int i) const { return 0.5 * (start(i) + start(i + 1)); }
};

/// The mean of the cell's texels; of cells that are finer, what is seen in their middle.
Colour colourOf(const HdrImage& padded, const Cells& columns, int x, const Cells& rows, int y) {
    if (columns.finer() || rows.finer()) {
        return sample(padded, static_cast<float>(columns.middle(x)), static_cast<float>(rows.middle(y)),
                      TexelFilter::Bilinear);
    }
    Colour sum;
    int count = 0;
    for (int v = rows.first(y); v < rows.first(y + 1); ++v) {
        for (int u = columns.first(x); u < columns.first(x + 1); ++u, ++count) sum += padded.at(u + 1, v + 1);
    }
    return sum / static_cast<float>(count);
}

void addCellsOfFace(const HdrImage& padded, int face, std::vector<EnvironmentCell>& cells) {
    const Cells side(padded.width - 2, 256);
    for (int y = 0; y < side.count; ++y) {
        for (int x = 0; x < side.count; ++x) {
            const Vec3d d = faceDirection(face, side.middle(x), side.middle(y));
            const double square = dot(d, d), distance = std::sqrt(square);
            const double area = 4 * (side.start(x + 1) - side.start(x)) * (side.start(y + 1) - side.start(y));
            cells.push_back(
                {cubeDirection(face, static_cast<float>(side.middle(x)), static_cast<float>(side.middle(y))) /
                     static_cast<float>(distance),
                 static_cast<float>(area / (square * distance)), colourOf(padded, side, x, side, y)});
        }
    }
}

void addCellsOfSphere(const HdrImage& padded, std::vector<EnvironmentCell>& cells) {
    const Cells columns(padded.width - 2, 1024), rows(padded.height - 2, 512);
    const auto angle = [](double turns) { return static_cast<float>(2 * kExactPi * turns); };
    for (int y = 0; y < rows.count; ++y) {
        const float polar = angle(rows.middle(y) / 2), half = angle((rows.start(y + 1) - rows.start(y)) / 4);
        const float ring = portableSin(polar), height = portableCos(polar);
        for (int x = 0; x < columns.count; ++x) {
            const float azimuth = angle(columns.middle(x) - 0.5);
            const float width = angle(columns.start(x + 1) - columns.start(x));
            cells.push_back({{ring * portableSin(azimuth), height, -ring * portableCos(azimuth)},
                             2 * ring * portableSin(half) * width,
                             colourOf(padded, columns, x, rows, y)});
        }
    }
}

class WeightedMean {
  public:
    void add(Colour c, double weight) {
        r_ += weight * c.r;
        g_ += weight * c.g;
        b_ += weight * c.b;
        weights_ += weight;
    }
    Colour get() const {
        return {static_cast<float>(r_ / weights_), static_cast<float>(g_ / weights_),
                static_cast<float>(b_ / weights_)};
    }

  private:
    double r_ = 0, g_ = 0, b_ = 0, weights_ = 0;
};

/// Texels weigh as much as their solid angle at their centre.
Colour meanOfFaces(const std::array<HdrImage, 6>& faces) {
    WeightedMean mean;
    const int n = faces[0].width;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double s = 2 * (x + 0.5) / n - 1, t = 2 * (y + 0.5) / n - 1;
            const double square = 1 + s * s + t * t;
            const double weight = 1 / (square * std::sqrt(square));
            for (const HdrImage& face : faces) mean.add(face.at(x, y), weight);
        }
    }
    return mean.get();
}

Colour meanOfSphere(const HdrImage& image) {
    WeightedMean mean;
    for (int y = 0; y < image.height; ++y) {
        const float polar = static_cast<float>(kExactPi * (y + 0.5) / image.height);
        mean.add(meanOfRow(image, y), portableSin(polar));
    }
    return mean.get();
}

void require(bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(message);
}

} // namespace

CubeCoordinate cubeCoordinate(Vec3 direction) {
    const FacePoint p = facePoint(direction.x, direction.y, direction.z);
    return {p.face, static_cast<float>(p.s), static_cast<float>(p.t)};
}

Vec3 cubeDirection(int face, float s, float t) {
    const Vec3d d = faceDirection(face, s, t);
    return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}

Environment Environment::fromCube(std::array<HdrImage, 6> faces, std::string name) {
    const int n = faces[0].width;
    for (const HdrImage& face : faces) {
        require(!face.empty() && face.width == n && face.height == n,
                "the six faces of a cube map must be squares of one size");
    }
    Environment environment;
    environment.name_ = std::move(name);
    environment.cube_ = true;
    environment.mean_ = meanOfFaces(faces);
    std::vector<HdrImage> bordered;
    bordered.reserve(6);
    for (int face = 0; face < 6; ++face) bordered.push_back(borderedFace(faces, face));
    environment.images_ = std::make_shared<const std::vector<HdrImage>>(std::move(bordered));
    return environment;
}

Environment Environment::fromEquirectangular(const HdrImage& image, std::string name) {
    require(!image.empty(), "an equirectangular image must not be empty");
    Environment environment;
    environment.name_ = std::move(name);
    environment.mean_ = meanOfSphere(image);
    environment.images_ =
        std::make_shared<const std::vector<HdrImage>>(std::vector<HdrImage>{borderedEquirectangular(image)});
    return environment;
}

Colour Environment::radiance(Vec3 direction, TexelFilter filter) const {
    assert(isFinite(direction) && direction != Vec3{});
    const std::vector<HdrImage>& images = *images_;
    if (rotation_ != 0)
        direction = {dot(axes_[0], direction), dot(axes_[1], direction), dot(axes_[2], direction)};
    if (cube_) {
        const CubeCoordinate c = cubeCoordinate(direction);
        return intensity * sample(images[static_cast<std::size_t>(c.face)], c.s, c.t, filter);
    }
    const Vec3 d = normalize(direction);
    // acos(y) as an angle of two coordinates, which keeps its precision near the poles.
    const float polar = portableAtan2(std::sqrt(d.x * d.x + d.z * d.z), d.y);
    const float u = 0.5F + portableAtan2(d.x, -d.z) * static_cast<float>(0.5 / kExactPi);
    return intensity * sample(images[0], u, polar * static_cast<float>(1 / kExactPi), filter);
}

std::vector<EnvironmentCell> Environment::cells() const {
    std::vector<EnvironmentCell> cells;
    const std::vector<HdrImage>& images = *images_;
    if (!cube_) addCellsOfSphere(images[0], cells);
    for (int face = 0; cube_ && face < 6; ++face)
        addCellsOfFace(images[static_cast<std::size_t>(face)], face, cells);
    if (rotation_ == 0) return cells;
    for (EnvironmentCell& cell : cells) cell.direction = turned(cell.direction);
    return cells;
}

const EnvironmentLight& Environment::light() const {
    std::call_once(light_->made, [&] { light_->light = EnvironmentLight(cells()); });
    return light_->light;
}

void Environment::turn(float degrees, Vec3 up) {
    const auto s = static_cast<float>(portableSinOfDegrees(static_cast<double>(degrees)));
    const auto c = static_cast<float>(portableCosOfDegrees(static_cast<double>(degrees)));
    const auto turned = [&](Vec3 axis) {
        const Vec3 along = up * dot(axis, up);
        return along + (axis - along) * c + cross(axis, up) * s;
    };
    axes_ = {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
    rotation_ = degrees;
    light_ = std::make_shared<LazyLight>();
}

} // namespace rtcore
