#include "rtcore/io/import/mesh/polygon.h"
#include "rtcore/io/import/scan/ply_elements.h"
#include "rtcore/io/import/scan/ply_numbers.h"
#include "rtcore/platform/large_vector.h"

#include <optional>
#include <vector>

namespace rtcore {

namespace {

bool isInteger(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

/// Where the list lies in a face of the file.
struct FaceLayout {
    explicit FaceLayout(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) {
            if (property.listLength) {
                length = *property.listLength;
                index = property.type;
            } else {
                (length ? behind : before) += sizeOf(property.type);
            }
        }
        bytesOfCorner = sizeOf(index);
        bytesOfRest = before + sizeOf(*length) + behind;
    }
    std::size_t bytesOf(std::uint64_t corners) const { return bytesOfRest + corners * bytesOfCorner; }

    std::size_t before = 0, behind = 0; ///< bytes of other properties
    std::optional<PlyType> length;
    PlyType index = PlyType::Int32;
    std::size_t bytesOfCorner, bytesOfRest;
};

template <typename Index>
class FaceReader {
  public:
    FaceReader(PlySource& source, const PlyElement& element, ScanMesh& mesh)
        : source_(source), element_(element), layout_(element), mesh_(mesh), toLength_(layout_.before),
          toList_(layout_.before + sizeOf(*layout_.length)) {}

    void read() {
        if (readTriangles()) return;
        while (face_ < element_.count) {
            const std::span<const std::byte> bytes = source_.in.ahead(wanted_);
            if (bytes.size() < wanted_) refuseCutOff(element_, face_);
            source_.in.skip(readWhole(bytes));
        }
    }

  private:
    /// If all are triangles, as mostly in scans: then it is known where each of them lies.
    bool readTriangles() {
        const auto isTriangle = [this](const std::byte* record) {
            return *layout_.length == PlyType::UInt8 && std::to_integer<int>(record[toLength_]) == 3;
        };
        const std::size_t size = layout_.bytesOf(3);
        if (source_.in.ahead(size).size() < size || !isTriangle(source_.in.ahead(size).data()) ||
            element_.count > source_.in.left() / size)
            return false;
        resizeLarge(mesh_.triangles, element_.count);
        const auto use = [&](std::uint64_t first, std::span<const std::byte> records) {
            Triangle* to = mesh_.triangles.data() + first;
            for (std::size_t at = 0; at < records.size(); at += size, ++to) {
                const std::byte* const record = records.data() + at;
                if (!isTriangle(record)) return false;
                for (std::size_t i = 0; i < 3; ++i) {
                    const auto vertex = vertexIn(record + toList_ + i * sizeof(Index));
                    if (!vertex) return false;
                    to->v[i] = *vertex;
                }
            }
            return true;
        };
        const bool all = source_.in.readRecords(element_.count, size, use);
        if (!all) mesh_.triangles.clear();
        return all;
    }

    /// The faces that are whole in `bytes`, of which it returns how many they take.
    std::size_t readWhole(std::span<const std::byte> bytes) {
        std::size_t at = 0;
        wanted_ = layout_.bytesOf(0);
        for (; face_ < element_.count && bytes.size() - at >= wanted_; ++face_) {
            const std::byte* const record = bytes.data() + at;
            const std::uint64_t corners = lengthAt(record + toLength_);
            const std::size_t size = layout_.bytesOf(corners);
            if (bytes.size() - at < size) {
                wanted_ = size;
                break;
            }
            add(record + toList_, corners);
            at += size;
        }
        return at;
    }

    std::uint64_t lengthAt(const std::byte* at) const {
        if (*layout_.length == PlyType::UInt8) return static_cast<std::uint64_t>(*at);
        const auto length = withPlyType(*layout_.length, [&](auto type) {
            return static_cast<std::int64_t>(plyNumber<decltype(type)>(at, source_.swapped));
        });
        if (length < 0 || static_cast<std::uint64_t>(length) > source_.in.left() / sizeof(Index))
            refuseDamaged(say("its face {0} claims to have {1} corners", face_, length));
        return static_cast<std::uint64_t>(length);
    }

    std::int64_t indexAt(const std::byte* at) const {
        return static_cast<std::int64_t>(plyNumber<Index>(at, source_.swapped));
    }
    /// Nothing for one that does not exist.
    std::optional<std::uint32_t> vertexIn(const std::byte* at) const {
        const std::int64_t index = indexAt(at);
        if (index < 0 || static_cast<std::uint64_t>(index) >= mesh_.positions.size()) return {};
        return static_cast<std::uint32_t>(index);
    }
    std::uint32_t vertexAt(const std::byte* at) const {
        const auto vertex = vertexIn(at);
        if (!vertex) {
            refuseDamaged(
                say("its face {0} names the vertex {1} of {2}", face_, indexAt(at), mesh_.positions.size()));
        }
        return *vertex;
    }

    void add(const std::byte* list, std::uint64_t corners) {
        const auto vertex = [&](std::size_t i) { return vertexAt(list + i * sizeof(Index)); };
        if (corners == 3) {
            mesh_.triangles.push_back({{vertex(0), vertex(1), vertex(2)}});
            return;
        }
        corners_.clear();
        places_.clear();
        for (std::size_t i = 0; i < corners; ++i) {
            corners_.push_back(vertex(i));
            places_.push_back(mesh_.positions[corners_.back()]);
        }
        if (corners < 3) {
            ++mesh_.ignoredPrimitives;
            return;
        }
        for (const Triangle& t : cutter_.cut(places_))
            mesh_.triangles.push_back({{corners_[t.v[0]], corners_[t.v[1]], corners_[t.v[2]]}});
    }

    PlySource& source_;
    const PlyElement& element_;
    const FaceLayout layout_;
    ScanMesh& mesh_;
    std::size_t toLength_, toList_; ///< from the beginning of a face
    std::uint64_t face_ = 0;
    std::size_t wanted_ = 1; ///< bytes of the next face, as far as known
    PolygonCutter cutter_;
    std::vector<std::uint32_t> corners_;
    std::vector<Vec3> places_;
};

} // namespace

bool areScanFaces(const PlyElement& element) {
    const PlyProperty* list = nullptr;
    for (const PlyProperty& property : element.properties) {
        if (!property.listLength) continue;
        if (list != nullptr) return false;
        list = &property;
    }
    return element.name == "face" && list != nullptr && isInteger(list->type) &&
           isInteger(*list->listLength) && (list->name == "vertex_indices" || list->name == "vertex_index");
}

void readPlyFaces(PlySource& source, const PlyElement& element, ScanMesh& mesh) {
    const FaceLayout layout(element);
    refuseMoreThanFile(source, element, layout.bytesOf(0));
    reserveLarge(mesh.triangles,
                 std::min<std::uint64_t>(element.count, source.in.left() / layout.bytesOf(3)));
    withPlyType(layout.index, [&](auto type) {
        using Index = decltype(type);
        if constexpr (std::is_integral_v<Index>) FaceReader<Index>(source, element, mesh).read();
    });
}

} // namespace rtcore
