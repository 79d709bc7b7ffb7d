/// glTF files of squares, one in front of the other, and what a camera before them sees.
#pragma once

#include "process/sample_scene.h"
#include "rtcore/io/images/image_file.h"
#include "unit/import/gltf_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace test {

/// (-1 -1 z) to (1 1 z), seen from +z; texture coordinates (0 0) to (1 1), with v up.
struct Square {
    float z = 0;
    std::string material;           ///< JSON
    std::vector<float> colour = {}; ///< of all corners; three or four numbers, or none
};

class QuadsFile {
  public:
    explicit QuadsFile(std::vector<Square> squares) : squares_(std::move(squares)) {}

    /// Further members of the file, each beginning with a comma: images, extensions.
    std::string more;
    std::string scenes = "\"scene\":0,\"scenes\":[{\"nodes\":ALL}]"; ///< ALL: of all squares

    std::string text() const {
        std::string nodes, meshes, materials, all;
        for (std::size_t i = 0; i < squares_.size(); ++i) {
            const std::string n = std::to_string(i), comma = i > 0 ? "," : "";
            nodes += comma + "{\"mesh\":" + n + "}";
            all += comma + n;
            materials += comma + squares_[i].material;
            meshes += comma + mesh(i);
        }
        std::string shown = scenes;
        if (const std::size_t at = shown.find("ALL"); at != std::string::npos)
            shown.replace(at, 3, "[" + all + "]");
        return "{\"asset\":{\"version\":\"2.0\"}," + shown + ",\"nodes\":[" + nodes + "],\"meshes\":[" +
               meshes + "],\"materials\":[" + materials + "]," + buffers() + more + "}";
    }

  private:
    static constexpr std::size_t kCorners = 6;

    std::string mesh(std::size_t i) const {
        const std::size_t first = 3 * i;
        const std::string colour =
            squares_[i].colour.empty() ? "" : ",\"COLOR_0\":" + std::to_string(first + 2);
        return "{\"primitives\":[{\"attributes\":{\"POSITION\":" + std::to_string(first) +
               ",\"TEXCOORD_0\":" + std::to_string(first + 1) + colour +
               "},\"material\":" + std::to_string(i) + "}]}";
    }

    /// A buffer and three accessors for each square.
    std::string buffers() const {
        std::string buffers, views, accessors;
        const auto add = [&](const std::vector<float>& values, const std::string& type,
                             const std::string& bounds) {
            const std::string n = std::to_string(count_++), comma = n == "0" ? "" : ",";
            const std::string bytes = std::to_string(values.size() * sizeof(float));
            buffers += comma + "{\"byteLength\":" + bytes +
                       ",\"uri\":\"data:application/octet-stream;base64," +
                       base64(std::as_bytes(std::span(values))) + "\"}";
            views += comma + "{\"buffer\":" + n + ",\"byteLength\":" + bytes + "}";
            accessors += comma + "{\"bufferView\":" + n + ",\"componentType\":5126,\"count\":6,\"type\":\"" +
                         type + "\"" + bounds + "}";
        };
        count_ = 0;
        for (const Square& square : squares_) {
            static constexpr std::array<std::array<float, 2>, kCorners> kUv{
                {{0, 1}, {1, 1}, {1, 0}, {0, 1}, {1, 0}, {0, 0}}}; // v down
            std::vector<float> positions, texcoords, colours;
            for (const auto& [u, v] : kUv) {
                positions.insert(positions.end(), {2 * u - 1, 1 - 2 * v, square.z});
                texcoords.insert(texcoords.end(), {u, v});
                colours.insert(colours.end(), square.colour.begin(), square.colour.end());
            }
            const std::string z = std::to_string(square.z);
            add(positions, "VEC3", ",\"min\":[-1,-1," + z + "],\"max\":[1,1," + z + "]");
            add(texcoords, "VEC2", "");
            if (colours.empty()) colours.resize(3 * kCorners);
            add(colours, colours.size() == 4 * kCorners ? "VEC4" : "VEC3", "");
        }
        return "\"buffers\":[" + buffers + "],\"bufferViews\":[" + views + "],\"accessors\":[" + accessors +
               "]";
    }

    std::vector<Square> squares_;
    mutable std::size_t count_ = 0;
};

/// A material of glTF: base colour with alpha, roughness, and further members, each beginning with a comma.
inline std::string metallicRoughness(const std::string& base, float roughness, const std::string& more = "") {
    return "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[" + base +
           "],\"metallicFactor\":0,\"roughnessFactor\":" + std::to_string(roughness) + "}" + more + "}";
}
/// Black, of radiance 1.
inline std::string emitting() { return metallicRoughness("0,0,0,1", 1, ",\"emissiveFactor\":[1,1,1]"); }

/// Models in a folder, and images of them.
class SeenFiles : public testing::Test {
  protected:
    struct Seen {
        rtcore::HdrImage image;
        std::string said;

        /// The mean of columns and rows from the first to before the last, in fractions of the image.
        rtcore::Colour mean(double fromX = 0, double toX = 1, double fromY = 0, double toY = 1) const {
            rtcore::Colour sum;
            int count = 0;
            const auto at = [](double fraction, int size) { return static_cast<int>(fraction * size); };
            for (int y = at(fromY, image.height); y < at(toY, image.height); ++y) {
                for (int x = at(fromX, image.width); x < at(toX, image.width); ++x, ++count)
                    sum += image.at(x, y);
            }
            return sum / static_cast<float>(count);
        }
    };

    /// The model by this integrator: no lights but those of `look`, and black around it unless `look` sets a
    /// background.
    Seen see(const std::string& model, const std::string& integrator, const std::string& look = "") {
        const std::string scene =
            "version = 2\nmodel = \"" + model + "\"\nambient = [0, 0, 0]\n" +
            "defaultLight = false\nmodelLights = false\n" +
            (look.find("background") == std::string::npos ? "background = [0, 0, 0]\n" : "") + look;
        writeText(folder / "s.scn", scene);
        return seeScene(folder / "s.scn", integrator);
    }
    Seen seeScene(const std::filesystem::path& scene, const std::string& integrator) {
        const ProgramResult result = renderer({scene.string(), "--integrator=" + integrator, "--samples=16",
                                               "-w", "32", "-h", "24", "-o", (folder / "s.pfm").string()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return {rtcore::readHdrImage(folder / "s.pfm"), result.error};
    }

    static constexpr const char* kStraight = "[camera]\neye = [0, 0, 3]\nforward = [0, 0, -1]\nfov = 10\n";
    /// Irradiance pi, straight on: a white matte surface has radiance 1.
    static constexpr const char* kSun = "[[light]]\nkind = \"directional\"\ndirection = [0, 0, -1]\n"
                                        "intensity = [3.1415927, 3.1415927, 3.1415927]\n";
    TemporaryFolder folder;
};

} // namespace test
