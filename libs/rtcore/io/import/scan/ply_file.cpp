#include "rtcore/io/import/scan/ply_file.h"

#include "rtcore/io/import/scan/ply_elements.h"
#include "rtcore/platform/error.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <bit>

namespace rtcore {

void refuseDamaged(const Sentence& problem) {
    throw FileError(FailureKind::BadData, "", say("{0}; it is damaged: copy or export it again", problem));
}

void refuseCutOff(const PlyElement& element, std::uint64_t read) {
    refuseDamaged(say("it ends after {0} of the {1} elements {2} that its head promises", read, element.count,
                      inQuotes(element.name)));
}

void refuseMoreThanFile(const PlySource& source, const PlyElement& element, std::size_t size) {
    const std::uint64_t max = size > 0 ? source.in.left() / size : element.count;
    if (element.count > max) {
        refuseDamaged(say("its head promises {0} elements {1}, for which it has no room", element.count,
                          inQuotes(element.name)));
    }
}

void skipPlyElements(PlySource& source, const PlyElement& element) {
    refuseMoreThanFile(source, element, element.fixedSize());
    source.in.skip(element.count * element.fixedSize());
}

bool isScan(const PlyHeader& header) {
    const auto& elements = header.elements;
    const auto vertices = std::find_if(elements.begin(), elements.end(), areScanVertices);
    const auto faces = std::find_if(elements.begin(), elements.end(), areScanFaces);
    const auto passedOver = [](const PlyElement& e) {
        return !e.hasList() && e.name != "material" && e.name != "tristrips";
    };
    return !header.isText && vertices < faces && faces != elements.end() &&
           std::all_of(elements.begin(), elements.end(),
                       [&](const PlyElement& e) { return passedOver(e) || &e == &*faces; });
}

bool isPlyCloud(const PlyHeader& header) {
    const auto& elements = header.elements;
    const auto fits = [](const PlyElement& e) {
        return !e.hasList() && e.name != "material" && (e.name != "vertex" || areScanVertices(e));
    };
    return !header.isText && std::ranges::any_of(elements, areScanVertices) &&
           std::ranges::all_of(elements, fits);
}

ScanMesh readPly(const InputFile& file, const PlyHeader& header, const LocalOrigin& origin,
                 const std::function<void()>& alive) {
    PlySource source{PieceReader(file, header.size, alive),
                     header.bigEndian != (std::endian::native == std::endian::big)};
    ScanMesh mesh;
    mesh.origin = origin;
    for (const PlyElement& element : header.elements) {
        if (areScanVertices(element)) {
            readPlyVertices(source, element, mesh);
        } else if (areScanFaces(element)) {
            readPlyFaces(source, element, mesh);
        } else {
            skipPlyElements(source, element);
        }
    }
    return mesh;
}

void refuseCutOffText(const InputFile& file, const PlyHeader& header, const std::function<void()>& alive) {
    PieceReader in(file, header.size, alive);
    std::uint64_t lines = 0;
    bool blank = true; // so far, of the line that is counted
    for (auto piece = in.ahead(1); !piece.empty(); in.skip(piece.size()), piece = in.ahead(1)) {
        for (const std::byte byte : piece) {
            if (byte == std::byte{'\n'}) {
                blank = true;
            } else if (blank && byte > std::byte{' '}) {
                blank = false;
                ++lines;
            }
        }
    }
    for (const PlyElement& element : header.elements) {
        if (lines < element.count) refuseCutOff(element, lines);
        lines -= element.count;
    }
}

} // namespace rtcore
