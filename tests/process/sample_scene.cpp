#include "process/sample_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <sstream>

namespace test {

namespace {

// Eight corners and six outward faces.
void writeBox(std::ostream& out, int& vertices, double x, double y, double z, double size) {
    for (int corner = 0; corner < 8; ++corner) {
        out << "v " << x + size * (corner & 1) << ' ' << y + size * (corner >> 1 & 1) << ' '
            << z + size * (corner >> 2 & 1) << '\n';
    }
    const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& face : faces) {
        out << 'f';
        for (const int corner : face) out << ' ' << vertices + corner + 1;
        out << '\n';
    }
    vertices += 8;
}

ProgramResult run(const std::string& program, std::vector<std::string> arguments,
                  const ProgramSettings& settings) {
    const bool asks = std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
        return argument.rfind("--progress", 0) == 0;
    });
    if (!asks && !arguments.empty()) arguments.insert(arguments.begin(), "--progress=none");
    return runProgram(programPath(program), arguments, settings);
}

} // namespace

std::filesystem::path programPath(const std::string& name) {
    return std::filesystem::path(RT_PROGRAM_FOLDER) / name;
}

ProgramResult renderer(const std::vector<std::string>& arguments, const ProgramSettings& settings) {
    return run("Renderer", arguments, settings);
}

ProgramResult bspBuilder(const std::vector<std::string>& arguments, const ProgramSettings& settings) {
    return run("BSPBuilder", arguments, settings);
}

void writeRoom(const std::filesystem::path& path) {
    std::ofstream out(path);
    int vertices = 0;
    writeBox(out, vertices, -20, -20.5, -20, 20);
    writeBox(out, vertices, 0, -20.5, -20, 20);
    for (int i = 0; i < 12; ++i) {
        const int column = i % 4, row = i / 4;
        writeBox(out, vertices, column * 1.5 - 3, 0, row * -1.5, 0.5 + 0.05 * i);
    }
}

void writeWaves(const std::filesystem::path& path, int side) {
    std::ofstream out(path);
    for (int z = 0; z <= side; ++z) {
        for (int x = 0; x <= side; ++x) {
            const double u = 20.0 * x / side - 10, v = 20.0 * z / side - 10;
            out << "v " << u << ' ' << 0.4 * std::sin(3 * u) * std::cos(2 * v) << ' ' << v << '\n';
        }
    }
    for (int z = 0; z < side; ++z) {
        for (int x = 0; x < side; ++x) {
            const int a = z * (side + 1) + x + 1;
            out << "f " << a << ' ' << a + side + 1 << ' ' << a + 1 << '\n';
            out << "f " << a + 1 << ' ' << a + side + 1 << ' ' << a + side + 2 << '\n';
        }
    }
}

void writeCamera(const std::filesystem::path& path, double x, const std::string& extra) {
    std::ostringstream text;
    text << "version = 1\neye = [" << std::showpoint << x << ", 2.0, 6.0]\nforward = [0.0, -0.2, -1.0]\n"
         << extra;
    writeText(path, text.str());
}

void writeText(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string readBytes(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

PictureSize pngSize(const std::string& bytes) {
    if (bytes.size() < 24 || bytes.rfind("\x89PNG\r\n\x1a\n", 0) != 0) return {};
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
        return static_cast<int>(value);
    };
    return {number(16), number(20)};
}

PictureSize pngFileSize(const std::filesystem::path& path) { return pngSize(readBytes(path)); }

std::vector<std::string> filesIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace test
