/// The elements of a binary PLY file that make a mesh.
#pragma once

#include "rtcore/io/import/scan/piece_reader.h"
#include "rtcore/io/import/scan/ply_header.h"
#include "rtcore/io/import/scan/scan_mesh.h"
#include "rtcore/platform/sentence.h"

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
