#include "rtcore/io/import/gltf/draco_mesh.h"

#ifdef RT_HAVE_DRACO
#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>
#endif

#include <algorithm>
#include <array>
#include <utility>

namespace rtcore::gltf {

#ifdef RT_HAVE_DRACO

namespace {

class DecodedMesh : public DracoMesh {
  public:
    explicit DecodedMesh(std::unique_ptr<draco::Mesh> mesh) : mesh_(std::move(mesh)) {}

    std::uint32_t vertices() const override { return mesh_->num_points(); }

    std::vector<Triangle> triangles() const override {
        std::vector<Triangle> list;
        list.reserve(mesh_->num_faces());
        for (std::uint32_t f = 0; f < mesh_->num_faces(); ++f) {
            const draco::Mesh::Face& face = mesh_->face(draco::FaceIndex(f));
            list.push_back({{face[0].value(), face[1].value(), face[2].value()}});
        }
        return list;
    }

    std::vector<float> floats(std::uint32_t number, std::uint32_t components) const override {
        const draco::PointAttribute* const attribute = mesh_->GetAttributeByUniqueId(number);
        if (attribute == nullptr || attribute->size() == 0) return {};
        std::vector<float> list(std::size_t{components} * vertices());
        std::array<float, kMax> values{};
        const auto there = static_cast<std::uint8_t>(std::min(components, kMax));
        for (std::uint32_t v = 0; v < vertices(); ++v) {
            const draco::AttributeValueIndex at = attribute->mapped_index(draco::PointIndex(v));
            if (at.value() >= attribute->size()) return {};
            if (!attribute->ConvertValue<float>(at, static_cast<std::int8_t>(there), values.data()))
                return {};
            std::copy_n(values.begin(), there, list.begin() + std::ptrdiff_t{components} * v);
        }
        return list;
    }

  private:
    static constexpr std::uint32_t kMax = 4;
    std::unique_ptr<draco::Mesh> mesh_;
};

} // namespace

bool readsDraco() { return true; }

std::unique_ptr<DracoMesh> DracoMesh::decode(std::span<const std::byte> code) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(code.data()), code.size());
    draco::Decoder decoder;
    auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok()) return nullptr;
    return std::make_unique<DecodedMesh>(std::move(mesh).value());
}

#else

bool readsDraco() { return false; }

std::unique_ptr<DracoMesh> DracoMesh::decode(std::span<const std::byte> /*code*/) { return nullptr; }

#endif

} // namespace rtcore::gltf
