#include "rtcore/io/import/gltf/meshopt_view.h"

#ifdef RT_HAVE_MESHOPT
#include <meshoptimizer.h>
#endif

namespace rtcore::gltf {

MeshoptView meshoptView(const Json& stated) {
    MeshoptView view;
    view.count = wholeNumber(stated, "count", 0);
    view.stride = wholeNumber(stated, "byteStride", 0);
    const std::string mode = text(stated, "mode"), filter = text(stated, "filter");
    view.mode = mode == "ATTRIBUTES"  ? MeshoptMode::Attributes
                : mode == "TRIANGLES" ? MeshoptMode::Triangles
                : mode == "INDICES"   ? MeshoptMode::Indices
                                      : MeshoptMode::None;
    view.filter = filter == "OCTAHEDRAL"    ? MeshoptFilter::Octahedral
                  : filter == "QUATERNION"  ? MeshoptFilter::Quaternion
                  : filter == "EXPONENTIAL" ? MeshoptFilter::Exponential
                                            : MeshoptFilter::None;
    return view;
}

#ifdef RT_HAVE_MESHOPT

namespace {

bool isPossible(const MeshoptView& view, std::size_t codeBytes) {
    // The densest code has two bits for sixteen bytes.
    constexpr std::uint64_t kMaxBytesOfOne = 64, kOfShortCode = 4096, kMaxCount = 0xFFFFFFFFU;
    if (view.count == 0 || view.count > kMaxCount || view.stride > 256) return false;
    const bool attributes = view.mode == MeshoptMode::Attributes;
    if (attributes ? view.stride == 0 || view.stride % 4 != 0 : view.stride != 2 && view.stride != 4)
        return false;
    if (view.mode == MeshoptMode::Triangles && view.count % 3 != 0) return false;
    return view.count * view.stride <= codeBytes * kMaxBytesOfOne + kOfShortCode;
}

bool isPossible(MeshoptFilter filter, std::uint64_t stride) {
    if (filter == MeshoptFilter::Octahedral) return stride == 4 || stride == 8;
    return filter != MeshoptFilter::Quaternion || stride == 8;
}

int decodeInto(std::vector<std::byte>& room, std::span<const std::byte> code, const MeshoptView& view) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(code.data());
    switch (view.mode) {
    case MeshoptMode::Attributes:
        return meshopt_decodeVertexBuffer(room.data(), view.count, view.stride, bytes, code.size());
    case MeshoptMode::Triangles:
        return meshopt_decodeIndexBuffer(room.data(), view.count, view.stride, bytes, code.size());
    case MeshoptMode::Indices:
        return meshopt_decodeIndexSequence(room.data(), view.count, view.stride, bytes, code.size());
    case MeshoptMode::None:
        break;
    }
    return -1;
}

void applyFilter(std::vector<std::byte>& room, const MeshoptView& view) {
    if (view.filter == MeshoptFilter::Octahedral)
        meshopt_decodeFilterOct(room.data(), view.count, view.stride);
    if (view.filter == MeshoptFilter::Quaternion)
        meshopt_decodeFilterQuat(room.data(), view.count, view.stride);
    if (view.filter == MeshoptFilter::Exponential)
        meshopt_decodeFilterExp(room.data(), view.count, view.stride);
}

} // namespace

bool readsMeshopt() { return true; }

std::vector<std::byte> decodeMeshopt(std::span<const std::byte> code, const MeshoptView& view) {
    const bool filtered = view.filter != MeshoptFilter::None;
    if (view.mode == MeshoptMode::None || !isPossible(view, code.size())) return {};
    if (filtered && (view.mode != MeshoptMode::Attributes || !isPossible(view.filter, view.stride)))
        return {};
    std::vector<std::byte> room(view.count * view.stride);
    if (decodeInto(room, code, view) != 0) return {};
    applyFilter(room, view);
    return room;
}

#else

bool readsMeshopt() { return false; }

std::vector<std::byte> decodeMeshopt(std::span<const std::byte> /*code*/, const MeshoptView& /*view*/) {
    return {};
}

#endif

} // namespace rtcore::gltf
