#include "rtcore/io/images/environment_file.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace rtcore {
namespace {

struct Cell {
    int column, row;
    bool turned = false; ///< by half a turn
};
using Cells = std::array<Cell, 6>;

constexpr Cells kWideCross{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
constexpr Cells kTallCross{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}};
constexpr Cells kRow{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}};
constexpr Cells kColumn{{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}};

HdrImage readRadiances(const std::filesystem::path& path) {
    HdrImage image = readHdrImage(path);
    for (Colour& c : image.pixels) c = {std::max(c.r, 0.0F), std::max(c.g, 0.0F), std::max(c.b, 0.0F)};
    return image;
}

[[noreturn]] void wrongShape(const std::filesystem::path& path, const HdrImage& image,
                             const Sentence& expected) {
    throw FileError(FailureKind::BadData, path.string(),
                    say("the image has {0} x {1} pixels; {2}", image.width, image.height, expected));
}

bool hasShape(const HdrImage& image, int columns, int rows) {
    return image.width % columns == 0 && image.height % rows == 0 &&
           image.width / columns == image.height / rows;
}

HdrImage cut(const HdrImage& image, Cell cell, int n) {
    HdrImage face(n, n);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const int sourceX = cell.turned ? n - 1 - x : x, sourceY = cell.turned ? n - 1 - y : y;
            face.at(x, y) = image.at(cell.column * n + sourceX, cell.row * n + sourceY);
        }
    }
    return face;
}

Environment fromCells(const HdrImage& image, const Cells& cells, int n, const std::filesystem::path& path) {
    std::array<HdrImage, 6> faces;
    std::transform(cells.begin(), cells.end(), faces.begin(), [&](Cell cell) { return cut(image, cell, n); });
    return Environment::fromCube(std::move(faces), path.stem().string());
}

bool isSphere(const HdrImage& image) { return image.width == 2 * image.height; }

std::optional<Environment> crossOf(const HdrImage& image, const std::filesystem::path& path) {
    if (hasShape(image, 4, 3)) return fromCells(image, kWideCross, image.width / 4, path);
    if (hasShape(image, 3, 4)) return fromCells(image, kTallCross, image.width / 3, path);
    return std::nullopt;
}

std::optional<Environment> stripOf(const HdrImage& image, const std::filesystem::path& path) {
    if (hasShape(image, 6, 1)) return fromCells(image, kRow, image.width / 6, path);
    if (hasShape(image, 1, 6)) return fromCells(image, kColumn, image.width, path);
    return std::nullopt;
}

} // namespace

Environment loadEquirectangular(const std::filesystem::path& path) {
    const HdrImage image = readRadiances(path);
    if (!isSphere(image)) wrongShape(path, image, "an equirectangular map is twice as wide as high");
    return Environment::fromEquirectangular(image, path.stem().string());
}

Environment loadCubeCross(const std::filesystem::path& path) {
    const HdrImage image = readRadiances(path);
    if (auto cross = crossOf(image, path)) return std::move(*cross);
    wrongShape(path, image, "a cross of cube faces has 4 x 3 or 3 x 4 squares");
}

Environment loadCubeStrip(const std::filesystem::path& path) {
    const HdrImage image = readRadiances(path);
    if (auto strip = stripOf(image, path)) return std::move(*strip);
    wrongShape(path, image, "a strip of cube faces has 6 x 1 or 1 x 6 squares");
}

Environment loadCubeFaces(const std::array<std::filesystem::path, 6>& paths) {
    std::array<HdrImage, 6> faces;
    for (std::size_t i = 0; i < 6; ++i) {
        faces[i] = readRadiances(paths[i]);
        const int n = faces[0].width;
        if (faces[i].width != n || faces[i].height != n) {
            wrongShape(paths[i], faces[i],
                       say("the faces of a cube are squares of one size, here {0} a side", n));
        }
    }
    return Environment::fromCube(std::move(faces), paths[0].stem().string());
}

Environment loadEnvironment(const EnvironmentFile& file) {
    switch (file.kind) {
    case EnvironmentKind::Cross:
        return loadCubeCross(file.files.at(0));
    case EnvironmentKind::Strip:
        return loadCubeStrip(file.files.at(0));
    case EnvironmentKind::Faces: {
        std::array<std::filesystem::path, 6> faces;
        std::copy_n(file.files.begin(), std::min<std::size_t>(6, file.files.size()), faces.begin());
        return loadCubeFaces(faces);
    }
    case EnvironmentKind::Equirectangular:
    case EnvironmentKind::Parts:
        break;
    }
    return loadEquirectangular(file.files.at(0));
}

OpenedEnvironment openEnvironment(const std::filesystem::path& path) {
    const HdrImage image = readRadiances(path);
    EnvironmentFile file;
    file.files = {path};
    if (isSphere(image)) return {file, Environment::fromEquirectangular(image, path.stem().string())};
    if (auto cross = crossOf(image, path)) {
        file.kind = EnvironmentKind::Cross;
        return {file, std::move(*cross)};
    }
    if (auto strip = stripOf(image, path)) {
        file.kind = EnvironmentKind::Strip;
        return {file, std::move(*strip)};
    }
    wrongShape(path, image,
               "an environment is twice as wide as high, or a cross of 4 x 3 or 3 x 4 squares, or a strip of "
               "6 x 1 or 1 x 6");
}

} // namespace rtcore
