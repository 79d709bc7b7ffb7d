#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/bsp/model_check.h"

#include "rtcore/accel/validation.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace rtcore {

namespace {

using Bytes = std::span<const std::byte>;

/// One file on its way from bytes to views; every step throws at the first fault.
class Reader {
  public:
    Reader(FileBytes file, const std::string& name)
        : file_(std::move(file)), bytes_(file_.bytes), name_(name) {}

    BspContent read() {
        readHeader();
        checkTable();
        checkPayload();
        BspContent content{
            readModel(), {}, {header_.sourceSize, header_.sourceCrc, header_.buildOptionsHash}};
        if (const auto problem = checkModel(content.model)) fail("section " + *problem);
        const Box3 bounds = readBounds();
        if (header_.hasTree == 1) content.tree = readTree(bounds, content.model.mesh.triangles.size());
        return content;
    }

  private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw FileError(FailureKind::BadData, name_, problem + "; build it again with BSPBuilder");
    }
    void require(bool condition, const char* problem) const {
        if (!condition) fail(problem);
    }

    void readHeader() {
        require(isBsp(bytes_), "is no .bsp file of this suite (other programs use the same ending)");
        require(bytes_.size() >= sizeof(BspHeader), "header: the file is cut off");
        std::memcpy(&header_, bytes_.data(), sizeof(BspHeader));
        require(header_.byteOrder == kBspByteOrder, "header: written by a machine of the other byte order");
        require(header_.version == kBspVersion, "header: written by another version of BSPBuilder");
        require(header_.headerSize == sizeof(BspHeader) && header_.sectionCount == kBspSections,
                "header: of the wrong size");
        require(header_.headerCrc == headerCrcOf(header_), "header: damaged (its checksum differs)");
        require(header_.fileSize >= bytes_.size(), "the file is longer than it should be");
        require(header_.fileSize <= bytes_.size(), "the file is cut off");
        require(header_.hasTree <= 1, "header: its flags make no sense");
        require(header_.reserved == decltype(header_.reserved){}, "header: its reserved fields are not zero");
    }

    /// Each section begins at the next multiple of 64 behind the one before and the last ends the file, so
    /// that none overlap and no byte is left over.
    void checkTable() const {
        const std::uint64_t size = bytes_.size();
        std::uint64_t end = sizeof(BspHeader);
        for (std::size_t i = 0; i < kBspSections; ++i) {
            const BspSectionEntry& entry = header_.sections[i];
            const std::uint64_t begin = (end + kBspAlignment - 1) / kBspAlignment * kBspAlignment;
            if (entry.elementSize != kBspElementSizes[i]) failSection(i, "has elements of the wrong size");
            if (entry.offset != begin || begin > size) failSection(i, "begins at the wrong place");
            if (entry.count > (size - begin) / entry.elementSize)
                failSection(i, "ends behind the end of the file");
            const auto gap = bytes_.subspan(end, begin - end);
            if (std::any_of(gap.begin(), gap.end(), [](std::byte b) { return b != std::byte{0}; })) {
                failSection(i, "has bytes before it that are not zero");
            }
            end = begin + entry.count * entry.elementSize;
        }
        require(end == size, "section strings does not end with the file");
        require(header_.hasTree == 1 ||
                    (entryOf(BspSection::Nodes).count == 0 && entryOf(BspSection::References).count == 0),
                "section nodes belongs to no tree");
    }

    [[noreturn]] void failSection(std::size_t i, const char* problem) const {
        fail(std::string("section ") + kBspSectionNames[i] + " " + problem);
    }

    void checkPayload() const {
        require(crc32Of(bytes_.subspan(sizeof(BspHeader))) == header_.payloadCrc,
                "the sections are damaged (their checksum differs)");
    }

    const BspSectionEntry& entryOf(BspSection section) const {
        return header_.sections[static_cast<std::size_t>(section)];
    }

    template <typename T>
    std::span<const T> view(BspSection section) const {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);
        const BspSectionEntry& entry = entryOf(section);
        if (entry.count == 0) return {};
        return {reinterpret_cast<const T*>(bytes_.data() + entry.offset), entry.count};
    }

    Model readModel() const {
        Model model;
        model.mesh = {view<Vertex>(BspSection::Vertices),         view<Triangle>(BspSection::Triangles),
                      view<ShadingTriangle>(BspSection::Shading), view<Vec3>(BspSection::Normals),
                      view<Vec2>(BspSection::Texcoords),          view<Colour>(BspSection::Colours)};
        model.materials = view<Material>(BspSection::Materials);
        model.textures = view<Texture>(BspSection::Textures);
        model.texels = view<Rgba8>(BspSection::Texels);
        model.lights = view<Light>(BspSection::Lights);
        model.cameras = view<Camera>(BspSection::Cameras);
        model.strings = view<char>(BspSection::Strings);
        model.storage = file_.owner;
        return model;
    }

    Box3 readBounds() const {
        const auto& lo = header_.boundsLo;
        const auto& hi = header_.boundsHi;
        const Box3 bounds{{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
        if (bounds == Box3{}) return bounds;
        // A builder may widen the box by a few units in the last place.
        constexpr float most = kLargestNumber * 1.001F;
        for (int a = 0; a < 3; ++a) {
            require(bounds.lo[a] >= -most && bounds.lo[a] <= bounds.hi[a] && bounds.hi[a] <= most,
                    "header: the bounds are no box");
        }
        return bounds;
    }

    KdTree readTree(const Box3& bounds, std::size_t triangleCount) const {
        KdTree tree{view<KdNode>(BspSection::Nodes), view<std::uint32_t>(BspSection::References), bounds,
                    file_.owner};
        if (const auto problem = validateKdTree(tree, triangleCount)) fail("section nodes: " + *problem);
        return tree;
    }

    FileBytes file_;
    Bytes bytes_;
    const std::string& name_;
    BspHeader header_{};
};

} // namespace

BspContent readBsp(const std::filesystem::path& path) { return readBsp(openFileBytes(path), path.string()); }

BspContent readBsp(FileBytes file, const std::string& name) { return Reader(std::move(file), name).read(); }

bool isBsp(std::span<const std::byte> head) {
    return head.size() >= kBspMagic.size() &&
           std::memcmp(head.data(), kBspMagic.data(), kBspMagic.size()) == 0;
}

} // namespace rtcore
