#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/bsp/model_check.h"

#include "rtcore/accel/mesh_bounds.h"
#include "rtcore/accel/validation.h"
#include "rtcore/platform/error.h"
#include "rtcore/scene/model_photometry.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace rtcore {

namespace {

using Bytes = std::span<const std::byte>;

constexpr std::array<std::byte, kBspAlignment> kZeros{};

/// Lights as files have them, and the distributions that they name by their place.
struct LightSections {
    std::vector<Light> lights;
    std::vector<double> luminaires;

    explicit LightSections(std::span<const Light> of) : lights(of.begin(), of.end()) {
        const std::vector<std::uint32_t> numbers = photometriesOf(of);
        for (const std::uint32_t number : numbers) {
            const std::vector<double> web = numbersOf(*keptWeb(number));
            luminaires.insert(luminaires.end(), web.begin(), web.end());
        }
        for (Light& light : lights) {
            if (light.photometry == 0) continue;
            const auto at = std::ranges::find(numbers, light.photometry);
            light.photometry = static_cast<std::uint32_t>(at - numbers.begin()) + 1;
        }
    }
};

/// In the order of BspSection; without blocks and luminaires as they were written before there were any.
std::vector<Bytes> contentOf(const Model& model, const LightSections& lights, const KdTree* tree,
                             std::string_view warnings, std::string_view origin) {
    const Mesh& mesh = model.mesh;
    const auto nodes = tree != nullptr ? tree->nodes : std::span<const KdNode>();
    const auto references = tree != nullptr ? tree->references : std::span<const std::uint32_t>();
    std::vector<Bytes> content{std::as_bytes(nodes),
                               std::as_bytes(references),
                               std::as_bytes(mesh.vertices),
                               std::as_bytes(mesh.triangles),
                               std::as_bytes(mesh.shading),
                               std::as_bytes(mesh.normals),
                               std::as_bytes(mesh.texcoords),
                               std::as_bytes(mesh.colours),
                               std::as_bytes(mesh.alphas),
                               std::as_bytes(mesh.furtherTexcoords),
                               std::as_bytes(model.materials),
                               std::as_bytes(model.textures),
                               std::as_bytes(model.texels),
                               std::as_bytes(std::span(lights.lights)),
                               std::as_bytes(model.cameras),
                               std::as_bytes(model.parts),
                               std::as_bytes(model.strings),
                               std::as_bytes(std::span(warnings)),
                               std::as_bytes(std::span(origin))};
    const bool luminaires = !lights.luminaires.empty();
    if (!model.blocks.empty() || luminaires) content.push_back(std::as_bytes(model.blocks));
    if (luminaires) content.push_back(std::as_bytes(std::span(lights.luminaires)));
    return content;
}

/// One line each, whatever they hold.
std::string linesOf(std::span<const std::string> warnings) {
    std::string lines;
    for (const std::string& warning : warnings) {
        if (lines.size() + warning.size() >= kMaxBspWarningBytes) break;
        for (const char c : warning) {
            const auto code = static_cast<unsigned char>(c);
            lines += code < 0x20 || code == 0x7F ? '?' : c;
        }
        lines += '\n';
    }
    return lines;
}

void refuseBadContent(const std::filesystem::path& path, const Model& model, const KdTree* tree) {
    auto problem = checkModel(model);
    if (!problem && tree != nullptr) {
        problem = validateKdTree(*tree, model.mesh.triangles.size());
        if (problem) problem = say("the kd-tree: {0}", *problem);
    }
    if (!problem) return;
    throw FileError(FailureKind::BadData, path.string(),
                    say("not written: the model cannot be used ({0}); repair the model's file", *problem));
}

Box3 boundsOf(const Mesh& mesh) {
    Box3 bounds;
#pragma omp parallel
#pragma omp single
    bounds = boundsInTasks(mesh);
    return bounds;
}

std::uint32_t versionOf(const Model& model, const LightSections& lights) {
    if (!lights.luminaires.empty()) return kBspVersion;
    return model.blocks.empty() ? kBspVersionWithoutBlocks : kBspVersionOfBlocks;
}

BspHead headOf(const Model& model, const KdTree* tree, const BspIdentity& identity) {
    const Box3 bounds = tree != nullptr ? tree->bounds : boundsOf(model.mesh);
    BspHead head{};
    head.magic = kBspMagic;
    head.byteOrder = kBspByteOrder;
    head.headSize = sizeof(BspHead);
    head.sourceSize = identity.sourceSize;
    head.sourceCrc = identity.sourceCrc;
    head.buildOptionsHash = identity.buildOptionsHash;
    head.boundsLo = {bounds.lo.x, bounds.lo.y, bounds.lo.z};
    head.boundsHi = {bounds.hi.x, bounds.hi.y, bounds.hi.z};
    head.hasTree = tree != nullptr ? 1 : 0;
    return head;
}

/// Where each section comes to lie.
std::vector<BspSectionEntry> tableOf(std::span<const Bytes> sections) {
    std::vector<BspSectionEntry> table(sections.size());
    std::uint64_t end = sizeof(BspHead) + std::span(table).size_bytes();
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const BspSectionKind& kind = kBspSectionKinds[i];
        std::copy(kind.name.begin(), kind.name.end(), table[i].name.begin());
        table[i].elementSize = kind.elementSize;
        table[i].offset = (end + kBspAlignment - 1) / kBspAlignment * kBspAlignment;
        table[i].count = sections[i].size() / kind.elementSize;
        end = table[i].offset + sections[i].size();
    }
    return table;
}

} // namespace

void writeBsp(const std::filesystem::path& path, const Model& model, const KdTree* tree,
              const BspIdentity& identity, std::span<const std::string> warnings, const ModelOrigin& origin) {
    refuseBadContent(path, model, tree);
    const std::string lines = linesOf(warnings), origins = writeOrigin(origin);
    const LightSections lights(model.lights);
    const std::vector<Bytes> sections = contentOf(model, lights, tree, lines, origins);
    const std::vector<BspSectionEntry> table = tableOf(sections);
    BspHead head = headOf(model, tree, identity);
    head.version = versionOf(model, lights);
    head.sectionCount = static_cast<std::uint32_t>(sections.size());

    std::vector<Bytes> pieces{std::as_bytes(std::span(&head, 1))};
    std::uint64_t end = sizeof(BspHead);
    const auto append = [&](Bytes bytes) {
        head.payloadCrc = crc32Of(bytes, head.payloadCrc);
        end += bytes.size();
        pieces.push_back(bytes);
    };
    append(std::as_bytes(std::span(table)));
    for (std::size_t i = 0; i < sections.size(); ++i) {
        append(Bytes(kZeros).first(table[i].offset - end));
        append(sections[i]);
    }
    head.fileSize = end;
    head.headCrc = headCrcOf(head);
    writeFileAtomically(path, pieces);
}

} // namespace rtcore
