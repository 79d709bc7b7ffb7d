/// glTF files with everything inside, written by tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace test {

inline std::string base64(std::span<const std::byte> bytes) {
    const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            word = word << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += i + k > bytes.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
        }
    }
    return out;
}

/// The triangle (0,0,0) (1,0,0) (0,1,0) with texture coordinates (0,0) (1,0) (0,1) - v down, as glTF has it -
/// and colours red, half grey, blue.
struct GltfScene {
    std::string nodes = R"({"mesh":0})"; ///< JSON, separated by commas
    std::string roots = "0";
    std::string material = "{}";
    std::string more; ///< further members, each beginning with a comma
    bool colours = false;

    static const std::vector<float>& data() {
        static const std::vector<float> floats{0, 0, 0, 1, 0, 0, 0,    1,    0,    0, 0, 1,
                                               0, 0, 1, 1, 0, 0, 0.5F, 0.5F, 0.5F, 0, 0, 1};
        return floats;
    }

    /// A .gltf with everything inside.
    std::string text() const {
        return json(R"(,"uri":"data:application/octet-stream;base64,)" +
                    base64(std::as_bytes(std::span(data()))) + '"');
    }

    /// The same as a .glb.
    std::string binary() const {
        std::string head = json("");
        head.resize((head.size() + 3) / 4 * 4, ' ');
        const std::string body(reinterpret_cast<const char*>(data().data()), data().size() * sizeof(float));
        return "glTF" + word(2) + word(28 + head.size() + body.size()) + word(head.size()) + "JSON" + head +
               word(body.size()) + std::string("BIN", 4) + body;
    }

  private:
    static std::string word(std::size_t value) {
        std::string bytes;
        for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFFU);
        return bytes;
    }

    std::string json(const std::string& uri) const {
        return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" +
               nodes + R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1)" +
               (colours ? R"(,"COLOR_0":2)" : "") + R"(},"material":0}]}],"materials":[)" + material +
               R"(],"buffers":[{"byteLength":96)" + uri +
               R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},)" +
               R"({"buffer":0,"byteOffset":36,"byteLength":24},{"buffer":0,"byteOffset":60,"byteLength":36}],)" +
               R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],)" +
               R"("max":[1,1,0]},{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"},)" +
               R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}])" + more + "}";
    }
};

} // namespace test
