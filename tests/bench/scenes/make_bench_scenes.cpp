// Writes the scenes of rtbench that are made, not found:
//   make_bench_scenes FOLDER     crowd.ply and slats.ply
#include "bench/scenes/crowd_hall.h"
#include "trees/slat_room.h"

#include "rtcore/platform/files.h"
#include "rtcore/scene/mesh.h"

#include <array>
#include <bit>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace {

static_assert(std::endian::native == std::endian::little);

#pragma pack(push, 1)
struct PlyFace {
    std::uint8_t corners = 3;
    std::array<std::uint32_t, 3> vertices{};
};
#pragma pack(pop)

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

void writePly(const std::filesystem::path& path, const rtcore::Mesh& mesh) {
    const std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
        std::to_string(mesh.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
    std::vector<std::array<float, 3>> vertices;
    for (const rtcore::Vertex& v : mesh.vertices) vertices.push_back({v.x, v.y, v.z});
    std::vector<PlyFace> faces;
    for (const rtcore::Triangle& t : mesh.triangles) faces.push_back({3, {t.v[0], t.v[1], t.v[2]}});
    const std::array pieces{std::as_bytes(std::span(header)), bytesOf(vertices), bytesOf(faces)};
    rtcore::writeFileAtomically(path, pieces);
    std::printf("%s: %zu triangles\n", path.c_str(), mesh.triangles.size());
}

} // namespace

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::fputs("Usage: make_bench_scenes FOLDER\nWrites crowd.ply and slats.ply there, for rtbench.\n",
                   stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    writePly(folder / "crowd.ply", bench::crowdInHall().view());
    writePly(folder / "slats.ply", test::SlatRoom({.corner = {-906.604F, 400, -1020}}).build().mesh());
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "make_bench_scenes: %s\n", error.what());
    return 1;
}
