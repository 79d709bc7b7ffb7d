// Large models, and Assimp alone, for scripts/performance/import.py, which measures its processes:
//   bench_import make whole|bare|objects|quads FILE    writes a model of ten million triangles
//   bench_import parse FILE                            Assimp's ReadFile() without post-processing
//   bench_import triangulate FILE                      with triangulation alone
//   bench_import prepare FILE                          with what rtimport does, too: triangles, equal
//   vertices
//                                                      joined, normals where there are none, bounds,
//                                                      validation
//   bench_import by-assimp FILE OUTPUT.bsp             rtimport as it was before it had readers of its own
#include "bench/import/large_models.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/import/assimp/assimp_import.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

namespace {

constexpr unsigned kPrepared = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                               aiProcess_GenSmoothNormals | aiProcess_ValidateDataStructure;

/// Ends the process, as rtimport does, before memory is freed.
[[noreturn]] void leave() {
    std::fflush(stdout);
    std::_Exit(0);
}

[[noreturn]] void readByAssimp(const std::string& path, unsigned steps) {
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(path, steps);
    if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
    std::uint64_t faces = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) faces += scene->mMeshes[i]->mNumFaces;
    std::printf("%u meshes, %llu faces\n", scene->mNumMeshes, static_cast<unsigned long long>(faces));
    leave();
}

[[noreturn]] void importByAssimp(const std::string& path, const std::string& output) {
    rtcore::FileImport result = rtcore::importWithAssimp(path, {});
    rtcore::writeBsp(output, rtcore::makeModel(std::move(result.model)), nullptr, {});
    leave();
}

bool run(std::string_view task, const std::string& first, const std::string& second) {
    if (task == "make" && !second.empty()) {
        bench::writeLargeModel(first, second);
        return true;
    }
    if (task == "parse") readByAssimp(first, 0);
    if (task == "triangulate") readByAssimp(first, aiProcess_Triangulate);
    if (task == "prepare") readByAssimp(first, kPrepared);
    if (task == "by-assimp" && !second.empty()) importByAssimp(first, second);
    return false;
}

} // namespace

int main(int argc, char** argv) {
    try {
        if (argc >= 3 && run(argv[1], argv[2], argc >= 4 ? argv[3] : "")) return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_import: %s\n", error.what());
        return 1;
    }
    std::fputs("Usage: bench_import make KIND FILE | parse FILE | triangulate FILE | prepare FILE | "
               "by-assimp FILE OUTPUT\n",
               stderr);
    return 2;
}
