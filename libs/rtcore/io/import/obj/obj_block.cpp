#include "rtcore/io/import/obj/obj_block.h"

#include "rtcore/io/import/obj/list_reader.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

template <typename T>
void appendRange(std::vector<T>& to, const std::vector<T>& from, std::size_t begin, std::size_t end) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
              from.begin() + static_cast<std::ptrdiff_t>(end));
}

/// Of lists that are empty as long as all elements, of which there were `before`, have their default.
template <typename T>
void appendSome(std::vector<T>& to, std::size_t before, const std::vector<T>& from, std::size_t begin,
                std::size_t end, const T& usual) {
    if (from.empty() && to.empty()) return;
    to.resize(before, usual);
    if (from.empty()) {
        to.resize(before + end - begin, usual);
    } else {
        appendRange(to, from, begin, end);
    }
}

/// Keeps the memory.
void clear(ObjLists& lists) {
    lists.positions.clear();
    lists.normals.clear();
    lists.texcoords.clear();
    lists.colours.clear();
    lists.corners.positions.clear();
    lists.corners.texcoords.clear();
    lists.corners.normals.clear();
    lists.sizes.clear();
    lists.faces = 0;
}

} // namespace

void ObjBlock::read(std::string_view text, const LocalOrigin& origin, bool texcoordsBefore) {
    clear(lists_);
    waiting_.clear();
    ObjListReader reader(lists_, origin, true, texcoordsBefore);
    StatementText in(text);
    while (!in.atEnd()) {
        if (!in.hasWord()) {
            in.endStatement();
        } else if (in.next() == '#') {
            in.endLine();
        } else {
            const StatementText statement = in;
            const std::string_view keyword = in.word();
            if (!ObjListReader::reads(keyword) || !reader.read(keyword, in))
                waiting_.push_back({statement, ends()});
            in.endStatement();
        }
    }
    lines_ = in.lines();
}

ObjBlock::Ends ObjBlock::ends() const {
    return {lists_.positions.size(), lists_.normals.size(), lists_.texcoords.size(),
            lists_.corners.positions.size(), lists_.faces};
}

void ObjBlock::append(ObjLists& to, const Ends& begin, const Ends& end) const {
    const std::size_t positions = to.positions.size(), corners = to.corners.positions.size();
    appendRange(to.positions, lists_.positions, begin.positions, end.positions);
    appendSome(to.colours, positions, lists_.colours, begin.positions, end.positions, kWhite);
    appendRange(to.normals, lists_.normals, begin.normals, end.normals);
    appendRange(to.texcoords, lists_.texcoords, begin.texcoords, end.texcoords);
    appendRange(to.corners.positions, lists_.corners.positions, begin.corners, end.corners);
    appendSome(to.corners.texcoords, corners, lists_.corners.texcoords, begin.corners, end.corners, kNoIndex);
    appendSome(to.corners.normals, corners, lists_.corners.normals, begin.corners, end.corners, kNoIndex);
    appendSome(to.sizes, to.faces, lists_.sizes, begin.faces, end.faces, 3U);
    to.faces += end.faces - begin.faces;
}

std::vector<std::string_view> partsOfStatements(std::string_view text, std::size_t bytes) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        std::size_t end = 0;
        for (std::size_t some = bytes; end == 0; some *= 2) // a statement may be longer
            end = some < text.size() ? wholeStatements(text.substr(0, some)) : text.size();
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return parts;
}

} // namespace rtcore
