#include "rtcore/io/import/obj/obj_reader.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/mesh/utf16_text.h"
#include "rtcore/io/import/obj/material_libraries.h"
#include "rtcore/io/import/obj/obj_structure.h"
#include "rtcore/io/import/text/statement_pieces.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/io/import/text/statement_warning.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/platform/paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

namespace rtcore {

namespace {

using View = std::string_view;

/// Names of statements that say nothing that is seen here: of smoothing, display and rendering.
constexpr std::array kPassedOver{View("s"),          View("mg"),        View("bevel"),  View("c_interp"),
                                 View("d_interp"),   View("lod"),       View("usemap"), View("maplib"),
                                 View("shadow_obj"), View("trace_obj"), View("ctech"),  View("stech"),
                                 View("vp")};

class ObjStatements {
  public:
    ObjStatements(const std::filesystem::path& path, const LocalOrigin& origin, ObjFile& file,
                  ImportReport& report)
        : origin_(origin), model_(file.model), materials_(file.materials), structure_(file.model),
          libraries_(path), report_(report) {}

    /// `text` is of whole statements.
    void read(View text) {
        StatementText in(text);
        while (!in.atEnd()) {
            if (!in.hasWord()) {
                in.endStatement();
            } else if (in.next() == '#') {
                in.endLine();
            } else {
                readStatement(in);
            }
        }
        lines_ += in.lines();
    }

    /// After a piece, if as many bytes as `piecesLeft` of that size follow: makes room for more of the same.
    void makeRoom(double piecesLeft) {
        const auto widen = [piecesLeft](auto& list, std::size_t& before) {
            const std::size_t added = list.size() - before;
            before = list.size();
            if (list.capacity() - list.size() >= added) return;
            reserveLarge(list, list.size() +
                                   static_cast<std::size_t>(static_cast<double>(added) * piecesLeft * 1.02));
        };
        widen(model_.positions, known_[0]);
        widen(model_.normals, known_[1]);
        widen(model_.texcoords, known_[2]);
        widen(model_.corners.positions, known_[3]);
        widen(model_.corners.texcoords, known_[4]);
        widen(model_.corners.normals, known_[5]);
        widen(model_.sizes, known_[6]);
    }

    void warn(const std::filesystem::path& path) {
        odd_.warn(path, report_);
        warnOf(libraries_.missing(), import_forms::kMissingLibrary, import_forms::kMissingLibraries);
        warnOf(libraries_.outside(), import_forms::kForeignLibrary, import_forms::kForeignLibraries);
        if (!unsupported_.empty()) addWarning(report_, say(import_forms::kIgnored, firstOf(unsupported_)));
        if (model_.segments > 0) addWarning(report_, say(import_forms::kLinesAndPoints, model_.segments));
    }

  private:
    void readStatement(StatementText& in) {
        const std::uint64_t line = lines_ + in.lines() + 1;
        const View keyword = in.word();
        const bool understood = keyword == "v"    ? readPosition(in)
                                : keyword == "f"  ? readFace(in)
                                : keyword == "vt" ? readTexcoord(in)
                                : keyword == "vn" ? readNormal(in)
                                                  : readOther(keyword, in);
        if (!understood) odd_.add(line, keyword);
        in.endStatement();
    }

    /// False for one that is not understood.
    bool readOther(View keyword, StatementText& in) {
        if (keyword == "fo") return readFace(in); // of earlier versions
        if (keyword == "l" || keyword == "p") return countSegments(keyword == "l", in);
        if (keyword == "g") {
            structure_.beginGroup(in.rest());
        } else if (keyword == "o") {
            structure_.beginObject(in.word());
        } else if (keyword == "usemtl") {
            useMaterial(in.rest());
        } else if (keyword == "mtllib") {
            readLibraries(in.rest());
        } else {
            return std::ranges::find(kPassedOver, keyword) != kPassedOver.end();
        }
        return true;
    }

    /// x y z, and a weight, a colour or a colour with an opacity behind them.
    bool readPosition(StatementText& in) {
        std::array<float, 8> numbers{};
        std::size_t count = 0;
        bool good = true;
        while (count < numbers.size() && in.hasWord() && in.next() != '#') {
            const auto number = count < 3 ? in.coordinate(origin_.at[count]) : in.number();
            good = good && number.has_value();
            numbers[count++] = number.value_or(std::numeric_limits<float>::quiet_NaN());
        }
        const auto& n = numbers;
        good = good && count >= 3;
        Vec3 position =
            good ? Vec3{n[0], n[1], n[2]} : Vec3{1, 1, 1} * std::numeric_limits<float>::quiet_NaN();
        if (good && count == 4 && n[3] != 0) position = divided(position, n[3]);
        model_.positions.push_back(position);
        if (good && (count == 6 || count == 7)) {
            model_.colours.resize(model_.positions.size(), kWhite);
            model_.colours.back() = {n[3], n[4], n[5]};
        } else if (!model_.colours.empty()) {
            model_.colours.push_back(kWhite);
        }
        return good;
    }

    /// A position whose numbers are to be divided by its weight, less the origin either way.
    Vec3 divided(Vec3 p, float weight) const {
        if (origin_.isZero()) return {p.x / weight, p.y / weight, p.z / weight};
        FilePoint point = origin_.inFile(p);
        for (double& each : point) each /= double{weight};
        return origin_.local(point);
    }

    bool readTexcoord(StatementText& in) {
        const auto x = in.number();
        const auto y = x && in.hasWord() && in.next() != '#' ? in.number() : std::optional(0.0F);
        const auto finite = [](float v) { return std::isfinite(v) ? v : 0.0F; };
        model_.texcoords.push_back(x && y ? Vec2{finite(*x), finite(*y)} : Vec2{});
        return x && y;
    }

    bool readNormal(StatementText& in) {
        const auto x = in.number(), y = in.number(), z = in.number();
        const bool good = x && y && z;
        model_.normals.push_back(good ? Vec3{*x, *y, *z} : Vec3{});
        return good;
    }

    /// From 0; kNoIndex for one that cannot be there.
    static std::uint32_t indexOf(std::int64_t number, std::size_t count) {
        const std::int64_t index = number > 0 ? number - 1 : static_cast<std::int64_t>(count) + number;
        return index >= 0 && index < std::int64_t{kNoIndex} ? static_cast<std::uint32_t>(index) : kNoIndex;
    }

    struct Corner {
        std::uint32_t position = kNoIndex, texcoord = kNoIndex, normal = kNoIndex;
    };
    /// "v", "v/t", "v//n" or "v/t/n"; nothing for what is none.
    std::optional<Corner> readCorner(StatementText& in) const {
        Corner corner;
        const auto position = in.wholeNumber();
        if (!position) return std::nullopt;
        corner.position = indexOf(*position, model_.positions.size());
        if (in.slash()) {
            const auto second = in.wholeNumber();
            const bool third = in.slash();
            const auto normal = third ? in.wholeNumber() : std::nullopt;
            // Without texture coordinates in the file, programs write "v/n".
            const bool secondIsNormal =
                second && !third && model_.texcoords.empty() && !model_.normals.empty();
            if (second && !secondIsNormal) corner.texcoord = indexOf(*second, model_.texcoords.size());
            if (secondIsNormal) corner.normal = indexOf(*second, model_.normals.size());
            if (normal) corner.normal = indexOf(*normal, model_.normals.size());
        }
        if (!in.endsWord()) return std::nullopt;
        return corner;
    }

    static void addIndex(std::vector<std::uint32_t>& list, std::uint32_t index, std::size_t at) {
        if (list.empty()) {
            if (index == kNoIndex) return;
            list.resize(at, kNoIndex);
        }
        list.push_back(index);
    }

    bool readFace(StatementText& in) {
        ObjCorners& corners = model_.corners;
        const std::size_t first = corners.positions.size();
        while (in.hasWord() && in.next() != '#') {
            const auto corner = readCorner(in);
            if (!corner) {
                corners.positions.resize(first);
                if (!corners.texcoords.empty()) corners.texcoords.resize(first, kNoIndex);
                if (!corners.normals.empty()) corners.normals.resize(first, kNoIndex);
                return false;
            }
            const std::size_t at = corners.positions.size();
            corners.positions.push_back(corner->position);
            addIndex(corners.texcoords, corner->texcoord, at);
            addIndex(corners.normals, corner->normal, at);
        }
        if (corners.positions.size() == first) return false;
        addFace(first);
        return true;
    }

    /// Of the corners from `first` on.
    void addFace(std::size_t first) {
        const std::size_t end = model_.corners.positions.size();
        const std::size_t size = end - first;
        if (size != 3 && model_.sizes.empty()) model_.sizes.assign(model_.faces, 3);
        if (size != 3 || !model_.sizes.empty()) model_.sizes.push_back(static_cast<std::uint32_t>(size));
        ObjMesh& mesh = model_.meshes[structure_.meshOfNext()];
        ++mesh.statements;
        if (mesh.runs.empty() || mesh.runs.back().endFace != model_.faces)
            mesh.runs.push_back({model_.faces, model_.faces, first, first});
        mesh.runs.back().endFace = ++model_.faces;
        mesh.runs.back().endCorner = end;
    }

    bool countSegments(bool isLine, StatementText& in) {
        std::uint64_t points = 0;
        for (; in.hasWord() && in.next() != '#'; in.word()) ++points;
        if (points == 0) return false;
        model_.segments += isLine ? points - 1 : points;
        ++model_.meshes[structure_.meshOfNext()].statements;
        return true;
    }

    void useMaterial(const std::string& name) {
        if (name.empty()) return;
        structure_.setMaterial(materials_.numberOf(name), name);
    }

    void readLibraries(const std::string& names) {
        if (names.empty() || !librariesAsked_.insert(names).second) return;
        for (const MaterialLibrary& library : libraries_.find(names)) {
            if (!librariesRead_.insert(library.path).second) continue;
            addFile(report_, plainPath(library.path).string());
            readMtl(library.path, library.folder, materials_, unsupported_, report_.origin.exporter, report_);
        }
    }

    void warnOf(const std::vector<std::string>& names, const char* one, const char* several) {
        if (!names.empty()) addWarning(report_, say(names.size() == 1 ? one : several, firstOf(names)));
    }

    LocalOrigin origin_;
    ObjModel& model_;
    MtlMaterials& materials_;
    ObjStructure structure_;
    LibraryFinder libraries_;
    std::set<std::string> librariesAsked_; ///< what statements named
    std::set<std::filesystem::path> librariesRead_;
    std::vector<std::string> unsupported_;
    ImportReport& report_;
    OddStatements odd_;
    std::uint64_t lines_ = 0;            ///< of the pieces before
    std::array<std::size_t, 7> known_{}; ///< lengths of lists after the last piece
};

/// It is read by pieces, as UTF-8 and what is like it.
void refuseUtf16(const InputFile& input) {
    std::array<std::byte, 2> mark{};
    if (beginsAsUtf16(std::span(mark).first(input.readAt(0, mark))))
        throw FileError(FailureKind::BadData, "",
                        say("its text is in UTF-16, which is not read; save it as UTF-8 in a text editor"));
}

} // namespace

ObjFile readObj(const std::filesystem::path& path, const LocalOrigin& origin, ImportReport& report,
                const std::function<void()>& alive) {
    ObjFile file;
    const InputFile input(path);
    refuseUtf16(input);
    ObjStatements statements(path, origin, file, report);
    forEachStatements(input, alive, [&](View text, std::uint64_t next) {
        statements.read(text);
        const std::uint64_t left = input.size() - std::min(input.size(), next);
        statements.makeRoom(static_cast<double>(left) / static_cast<double>(text.size() + 1));
    });
    statements.warn(path);
    return file;
}

} // namespace rtcore
