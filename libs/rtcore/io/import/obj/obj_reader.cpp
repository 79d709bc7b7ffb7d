#include "rtcore/io/import/obj/obj_reader.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/mesh/utf16_text.h"
#include "rtcore/io/import/obj/list_reader.h"
#include "rtcore/io/import/obj/material_libraries.h"
#include "rtcore/io/import/obj/obj_block.h"
#include "rtcore/io/import/obj/obj_structure.h"
#include "rtcore/io/import/text/statement_pieces.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/io/import/text/statement_warning.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/platform/paths.h"
#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <array>
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

/// Large enough for the threads, and small enough for their caches.
constexpr std::size_t kBytesOfBlock = std::size_t{256} << 10;

class ObjStatements {
  public:
    ObjStatements(const std::filesystem::path& path, const LocalOrigin& origin, ObjFile& file,
                  ImportReport& report)
        : origin_(origin), model_(file.model), lists_(file.model, origin, false), materials_(file.materials),
          structure_(file.model), libraries_(path), report_(report) {}

    /// `text` is of whole statements.
    void read(View text) {
        const std::vector<View> parts = partsOfStatements(text, kBytesOfBlock);
        if (blocks_.size() < parts.size()) blocks_.resize(parts.size());
        const bool texcoordsBefore = !model_.texcoords.empty();
        TaskErrors errors;
#pragma omp parallel for schedule(dynamic, 1) if (parts.size() > 1)
        for (std::size_t i = 0; i < parts.size(); ++i)
            errors.guard([&] { blocks_[i].read(parts[i], origin_, texcoordsBefore); });
        errors.rethrow();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            blocks_[i].moveTo(
                model_, [this](StatementText in) { readStatement(in); }, [this] { noteFaces(); });
            lines_ += blocks_[i].lines();
        }
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
        const bool ofLists = ObjListReader::reads(keyword);
        if (ofLists ? lists_.read(keyword, in) : readOther(keyword, in)) return noteFaces();
        if (ofLists) lists_.addDamaged(keyword);
        odd_.add(line, keyword);
    }

    /// False for one that is not understood.
    bool readOther(View keyword, StatementText& in) {
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

    /// Those that were added belong to the mesh at hand.
    void noteFaces() {
        if (model_.faces == notedFaces_) return;
        ObjMesh& mesh = model_.meshes[structure_.meshOfNext()];
        mesh.statements += model_.faces - notedFaces_;
        if (mesh.runs.empty() || mesh.runs.back().endFace != notedFaces_)
            mesh.runs.push_back({notedFaces_, notedFaces_, notedCorners_, notedCorners_});
        notedFaces_ = mesh.runs.back().endFace = model_.faces;
        notedCorners_ = mesh.runs.back().endCorner = model_.corners.positions.size();
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
    ObjListReader lists_; ///< for statements that blocks leave
    std::vector<ObjBlock> blocks_;
    std::size_t notedFaces_ = 0, notedCorners_ = 0; ///< that belong to meshes
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
