#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/bsp/model_check.h"

#include "rtcore/accel/validation.h"
#include "rtcore/platform/error.h"

#include <vector>

namespace rtcore {

namespace {

using Bytes = std::span<const std::byte>;

constexpr std::array<std::byte, kBspAlignment> kZeros{};

/// In the order of BspSection.
std::array<Bytes, kBspSections> contentOf(const Model& model, const KdTree* tree) {
    const Mesh& mesh = model.mesh;
    const auto nodes = tree != nullptr ? tree->nodes : std::span<const KdNode>();
    const auto references = tree != nullptr ? tree->references : std::span<const std::uint32_t>();
    return {std::as_bytes(nodes),          std::as_bytes(references),   std::as_bytes(mesh.vertices),
            std::as_bytes(mesh.triangles), std::as_bytes(mesh.shading), std::as_bytes(mesh.normals),
            std::as_bytes(mesh.texcoords), std::as_bytes(mesh.colours), std::as_bytes(model.materials),
            std::as_bytes(model.textures), std::as_bytes(model.texels), std::as_bytes(model.lights),
            std::as_bytes(model.cameras),  std::as_bytes(model.strings)};
}

void refuseBadContent(const std::filesystem::path& path, const Model& model, const KdTree* tree) {
    auto problem = checkModel(model);
    if (!problem && tree != nullptr) {
        problem = validateKdTree(*tree, model.mesh.triangles.size());
        if (problem) problem = "the kd-tree: " + *problem;
    }
    if (!problem) return;
    throw FileError(FailureKind::BadData, path.string(),
                    "not written: the model cannot be used (" + *problem + "); repair the model's file");
}

BspHeader headerOf(const Model& model, const KdTree* tree, const BspIdentity& identity) {
    const Box3 bounds = tree != nullptr ? tree->bounds : model.mesh.bounds();
    BspHeader header{};
    header.magic = kBspMagic;
    header.byteOrder = kBspByteOrder;
    header.version = kBspVersion;
    header.headerSize = sizeof(BspHeader);
    header.sectionCount = kBspSections;
    header.sourceSize = identity.sourceSize;
    header.sourceCrc = identity.sourceCrc;
    header.buildOptionsHash = identity.buildOptionsHash;
    header.boundsLo = {bounds.lo.x, bounds.lo.y, bounds.lo.z};
    header.boundsHi = {bounds.hi.x, bounds.hi.y, bounds.hi.z};
    header.hasTree = tree != nullptr ? 1 : 0;
    return header;
}

} // namespace

void writeBsp(const std::filesystem::path& path, const Model& model, const KdTree* tree,
              const BspIdentity& identity) {
    refuseBadContent(path, model, tree);
    BspHeader header = headerOf(model, tree, identity);

    std::vector<Bytes> pieces{std::as_bytes(std::span(&header, 1))};
    std::uint64_t end = sizeof(BspHeader);
    const auto append = [&](Bytes bytes) {
        header.payloadCrc = crc32Of(bytes, header.payloadCrc);
        end += bytes.size();
        pieces.push_back(bytes);
    };
    const auto sections = contentOf(model, tree);
    for (std::size_t i = 0; i < kBspSections; ++i) {
        append(Bytes(kZeros).first((kBspAlignment - end % kBspAlignment) % kBspAlignment));
        header.sections[i] = {end, sections[i].size() / kBspElementSizes[i], kBspElementSizes[i]};
        append(sections[i]);
    }
    header.fileSize = end;
    header.headerCrc = headerCrcOf(header);
    writeFileAtomically(path, pieces);
}

} // namespace rtcore
