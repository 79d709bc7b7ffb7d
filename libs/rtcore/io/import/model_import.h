/// 3D models of every format that Assimp reads.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/scene/model.h"
#include "rtcore/scene/pose_choice.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace rtcore {

inline constexpr float kCreaseAngle = 40;
inline constexpr float kDeflection = 0.0005F;

inline constexpr double kImportSeconds = 15;
inline constexpr double kImportSecondsPerByte = 2e-6; ///< of the file
inline constexpr std::uint64_t kTinyModel = 64'000;   ///< bytes; a smaller file gets
inline constexpr double kTinyModelSeconds = 5;

struct ImportOptions {
    std::optional<float> creaseAngle; ///< degrees: where a file has no normals, sharper edges stay edges;
                                      ///< absent: kCreaseAngle
    std::optional<float> deflection;  ///< how far triangles may lie off the surfaces of CAD files, as a
                                      ///< fraction of the model's diagonal, 1e-6 to 0.1; absent: kDeflection
    std::optional<bool> flipTextures; ///< turn all textures upside down: some exporters count v from the top
    std::optional<PoseChoice> pose;   ///< of what the file animates; absent: as its nodes say
    /// Stated by the user, whatever the file says; the model is neither turned nor scaled.
    std::optional<Vec3> up;              ///< one of the six axes
    std::optional<double> metresPerUnit; ///< above 0
    std::uint64_t memoryLimit = 0;       ///< bytes the importer may use; 0 = importLimits()
    double timeLimit = 0; ///< seconds the importer may take for one step (parsing, one image, one mesh);
                          ///< 0 = importLimits()
    int threads = 0;      ///< 0 = all cores; the model does not depend on it
    const std::atomic<bool>* stop = nullptr; ///< becomes true: give up with FailureKind::Stopped
};

struct ImportLimits {
    std::uint64_t memory = 0; ///< bytes
    double seconds = 0;       ///< for one step
};
/// The importer's limits: those of `options`, else half of the machine's memory - a small file may name large
/// images -, and kImportSeconds plus kImportSecondsPerByte times the file's size, less for a tiny file other
/// than a .gltf, whose buffers are files of their own. Holes in the file do not count.
ImportLimits importLimits(const std::filesystem::path& path, const ImportOptions& options = {});

struct ImportedModel {
    Model model;
    ImportReport report;
};

/// Imports a model in a program of its own (`rtimport`, a helperProgram(), or what the environment variable
/// RT_IMPORTER names), so that a file that crashes, hangs or starves Assimp gives an error and nothing worse.
/// The program hands over a .bsp without a tree, which is checked like any other. Beside the model's file
/// Assimp and this function read what it names: material libraries, buffers, images.
///
/// The model has at least one triangle; its vertices are welded where positions are equal, its normals
/// complete, its materials within their ranges. What was left out or is missing - an image, say - is in the
/// report. Safe from many threads. Throws FileError: NoInput (no file), BadData (cannot be imported),
/// CannotWrite or TryAgain (no room to hand over), Stopped.
ImportedModel importModel(const std::filesystem::path& path, const ImportOptions& options = {});

} // namespace rtcore
