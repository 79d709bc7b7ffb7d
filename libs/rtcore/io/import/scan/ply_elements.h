/// The elements of a binary PLY file that make a mesh.
#pragma once

#include "rtcore/io/import/materials/colour_decoder.h"
#include "rtcore/io/import/scan/piece_reader.h"
#include "rtcore/io/import/scan/ply_header.h"
#include "rtcore/io/import/scan/scan_mesh.h"
#include "rtcore/platform/sentence.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

/// Where in the file the elements are read from.
struct PlySource {
    PieceReader in;
    bool swapped; ///< bytes are in the other order than the machine's
};

/// Numbers only, x, y and z among them.
bool areScanVertices(const PlyElement& element);
/// Positions, normals, texture coordinates and colours, as far as they are there. Throws FileError BadData
/// when the file ends before the last, std::bad_alloc.
void readPlyVertices(PlySource& source, const PlyElement& element, ScanMesh& mesh);

/// Vertices as they come, one after another, from files of text among others.
class PlyVertexRows {
  public:
    /// `mesh` must outlive the object.
    PlyVertexRows(const PlyElement& element, ScanMesh& mesh);
    /// The numbers of a vertex, in the order of the properties.
    void add(std::span<const double> numbers);

  private:
    struct Field {
        std::size_t property;
        PlyType type;
        std::size_t attribute, component;
    };
    ScanMesh& mesh_;
    std::vector<Field> fields_;
    std::array<bool, 4> has_{}; ///< by attribute
    ColourDecoder decode_{false};
};

/// A part of a colour as a fraction of 1, by the type of its property.
float plyFraction(PlyType type, double number);
/// Which part of a colour a property is: 0 to 2; nothing for what is none.
std::optional<std::size_t> plyColourComponent(const PlyProperty& property);

/// Numbers and one list: the indices.
bool areScanFaces(const PlyElement& element);
/// After the vertices. Throws the same, also for a face that names a vertex that does not exist.
void readPlyFaces(PlySource& source, const PlyElement& element, ScanMesh& mesh);

/// Passes over elements of a fixed size. Throws FileError BadData when the file ends before the last.
void skipPlyElements(PlySource& source, const PlyElement& element);

/// Throws when so many elements of at least `size` bytes cannot be in the file: before memory is taken.
void refuseMoreThanFile(const PlySource& source, const PlyElement& element, std::size_t size);
[[noreturn]] void refuseCutOff(const PlyElement& element, std::uint64_t read);
[[noreturn]] void refuseDamaged(const Sentence& problem);

} // namespace rtcore
