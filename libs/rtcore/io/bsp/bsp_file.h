/// .bsp files: a model and its kd-tree, in a form that is used where it lies. Layout: bsp_layout.h.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/platform/files.h"
#include "rtcore/scene/model.h"
#include "rtcore/scene/model_origin.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rtcore {

/// The source and the options of a .bsp, to tell whether it is out of date.
struct BspIdentity {
    std::uint64_t sourceSize = 0;       ///< bytes of the model's file
    std::uint32_t sourceCrc = 0;        ///< CRC-32 of the model's file
    std::uint32_t buildOptionsHash = 0; ///< of the build options; 0 without a tree
    friend bool operator==(const BspIdentity&, const BspIdentity&) = default;
};

struct BspContent {
    Model model;
    std::optional<KdTree> tree; ///< none in a file that only hands over an imported model
    BspIdentity identity;
    std::vector<std::string> warnings; ///< what its import left out or changed, each one line
    ModelOrigin origin;                ///< of the model's file; empty in files of earlier writers
};

/// Writes by replaceFile(): a reader sees the old file or all of the new one, whenever the writer is killed.
/// `tree` may be null; `warnings` and `origin` are kept with the model, at most 64 KB and 4 KB of them. The
/// same content gives the same bytes.
/// Throws FileError: CannotWrite, and BadData when the model or the tree breaks a rule of checkModel() or
/// validateKdTree(), since readBsp() would refuse the file.
void writeBsp(const std::filesystem::path& path, const Model& model, const KdTree* tree,
              const BspIdentity& identity, std::span<const std::string> warnings = {},
              const ModelOrigin& origin = {});

/// Maps the file and checks all of it - checksums, structure, every index, every number - before it returns
/// views into the mapping, which `model.storage` and `tree->storage` own; sections of version 2 whose
/// elements were shorter then are copied. About 10 ms for a million triangles. Safe from many threads. Throws
/// FileError: NoInput, and BadData that names the section at fault.
BspContent readBsp(const std::filesystem::path& path);

/// The same for bytes that are in memory; `name` stands for the file in messages. The first byte must be
/// aligned to 16, as openFileBytes() gives it.
BspContent readBsp(FileBytes file, const std::string& name);

/// Whether a file that begins with these bytes (8 suffice) claims to be a .bsp of this suite.
bool isBsp(std::span<const std::byte> head);

} // namespace rtcore
