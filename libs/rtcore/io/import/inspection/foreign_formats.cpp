#include "rtcore/io/import/inspection/foreign_formats.h"

#include "rtcore/io/import/mesh/utf16_text.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace rtcore {

namespace {

using View = std::string_view;
using namespace std::string_view_literals;

/// As much as is looked through: the schema of a STEP file stands behind descriptions of any length.
constexpr std::size_t kLookedThrough = 65536;

std::string lowerCase(View text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string headOfFile(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return {};
    InputFile file(path);
    const auto bytes = file.head(kLookedThrough);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Text behind the mark of its encoding and blanks.
View textBeginning(View head) {
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    return head;
}

bool has(View text, View what) { return text.find(what) != View::npos; }

/// The first number behind `word`; 0 where there is none.
int numberBehind(View text, View word) {
    const std::size_t at = text.find(word);
    if (at == View::npos) return 0;
    View rest = text.substr(at + word.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t:"), rest.size()));
    int number = 0;
    std::from_chars(rest.data(), rest.data() + rest.size(), number);
    return number;
}

// Remedies, each as the end of a sentence.

constexpr auto kUnpack = form("unpack it and give the model inside");
constexpr auto kFromUsd = form("export the model as glTF, OBJ or PLY from the app that made it, or by "
                               "Blender (blender.org), which opens it");
constexpr auto kAsGltf = form("export the model as glTF");
constexpr auto kAsGltfOrObj = form("export the model as glTF or OBJ");
constexpr auto kFromCad = form("export it as STL, 3MF or glTF from the CAD program");
constexpr auto kMeshOfIt = form("make a mesh of it (CloudCompare, MeshLab) and save that as PLY");
constexpr auto kDownload = form("download the file itself");

Sentence itIs(const char* what, const char* remedy) { return say("it is {0}; {1}", what, remedy); }

/// Only said where rtimport_cad is missing.
Sentence unreadCad(const char* what) {
    return say("it is {0} of CAD surfaces, which this build does not read, as it lacks Open CASCADE; {1}",
               what, kFromCad);
}

// Formats whose version or content decides whether they are read; nothing where they are.

/// The schema of a STEP file; "" where it says none, nothing for what is no such file.
std::optional<View> stepSchema(View head) {
    const View text = textBeginning(head);
    if (!text.starts_with("ISO-10303-21")) return std::nullopt;
    const std::size_t at = text.find("FILE_SCHEMA");
    View schema = at == View::npos ? View() : text.substr(at);
    schema = schema.substr(0, schema.find(';'));
    const std::size_t quote = schema.find('\'');
    schema = quote == View::npos ? View() : schema.substr(quote + 1);
    return schema.substr(0, schema.find('\''));
}

bool isCadSchema(View schema, const std::string& ending) {
    return !schema.starts_with("IFC") && !(schema.empty() && ending == ".ifc");
}

std::optional<Sentence> step(View head, const std::string& ending) {
    const auto schema = stepSchema(head);
    if (!schema) return std::nullopt;
    if (schema->starts_with("IFC") && !schema->starts_with("IFC2X3"))
        return say("it is a building in {0}, which is not read; export it as IFC2x3 or as glTF",
                   schema->substr(0, 20));
    if (!isCadSchema(*schema, ending)) return std::nullopt;
    return unreadCad(form("a STEP file"));
}

/// The name of the first file in a zip archive.
View firstInArchive(View head) {
    constexpr std::size_t kLength = 26, kName = 30;
    if (head.size() < kName) return {};
    const auto byte = [head](std::size_t at) {
        return static_cast<std::size_t>(static_cast<unsigned char>(head[at]));
    };
    return head.substr(kName, byte(kLength) + (byte(kLength + 1) << 8U));
}

/// Its first file is the scene, by the format; some programs write others before it.
bool isUsdz(View head) {
    const std::string first = lowerCase(firstInArchive(head));
    const auto ends = [&](const char* ending) { return first.ends_with(ending); };
    return ends(".usd") || ends(".usda") || ends(".usdc") || has(head, ".usdc") || has(head, ".usda");
}

std::optional<Sentence> zip(View head, const std::string& ending) {
    if (!head.starts_with("PK\x03\x04"sv)) return std::nullopt;
    if (ending == ".usdz" || isUsdz(head)) return itIs(form("a USDZ file, which is not read"), kFromUsd);
    static constexpr std::array kPacked{".3mf"sv, ".kmz"sv, ".zae"sv, ".ifczip"sv, ".pk3"sv};
    if (std::ranges::find(kPacked, View(ending)) != kPacked.end()) return std::nullopt;
    if (ending == ".fcstd" || has(head, "GuiDocument.xml"))
        return say("it is a document of FreeCAD, which is not read; export it as STL, 3MF or glTF");
    if (has(head, "3D/3dmodel.model"))
        return say("it is a 3MF file by its content; rename it so that it ends in .3mf");
    return itIs(form("a zip archive"), kUnpack);
}

std::optional<Sentence> oldFbx(View head, const std::string&) {
    int version = 0;
    if (head.starts_with("Kaydara FBX Binary  \0"sv) && head.size() >= 27) {
        std::memcpy(&version, head.data() + 23, sizeof version);
    } else if (textBeginning(head).starts_with("; FBX")) {
        version = numberBehind(head, "FBXVersion");
    }
    if (version <= 0 || version >= 7100) return std::nullopt;
    return say("it is an FBX file of version {0}.{1}, from before 2011, which is not read; save it as FBX "
               "2011 or later, or as glTF",
               version / 1000, version % 1000 / 100);
}

/// Assimp knows their structure up to 3.3, packed by gzip, too; since 3.0 they are packed by zstd.
std::optional<Sentence> blend(View head, const std::string& ending) {
    constexpr int kFirstUnread = 304;
    int version = 0;
    if (head.starts_with("BLENDER") && head.size() >= 12)
        std::from_chars(head.data() + 9, head.data() + 12, version);
    const bool packed = ending == ".blend" && head.starts_with("\x28\xB5\x2F\xFD");
    if (version < kFirstUnread && !packed) return std::nullopt;
    if (packed) return say("it is a file of Blender, which is not read; export it as glTF from Blender");
    return say("it is a file of Blender {0}.{1}, which is not read; export it as glTF from Blender",
               version / 100, version % 100);
}

std::optional<Sentence> compound(View head, const std::string& ending) {
    if (!head.starts_with("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1")) return std::nullopt;
    if (ending == ".rvt" || ending == ".rfa")
        return say("it is a model of Revit, which is not read; export it as IFC2x3, FBX or glTF from Revit");
    if (ending == ".max")
        return say("it is a scene of 3ds Max, which is not read; export it as FBX or glTF from 3ds Max");
    return say("it is a file of a CAD program, which is not read; export it as STL, 3MF or glTF from that "
               "program");
}

std::optional<Sentence> iges(View head, const std::string&) {
    constexpr std::size_t kLine = 72; // then stand the section, S, and the number of the line
    if (head.size() < kLine + 8 || head[kLine] != 'S' || !has(head.substr(kLine + 1, 7), "1"))
        return std::nullopt;
    if (has(head.substr(0, kLine), "\n")) return std::nullopt;
    return unreadCad(form("an IGES file"));
}

std::optional<Sentence> brep(View head, const std::string&) {
    const View text = textBeginning(head);
    if (!text.starts_with("DBRep_DrawableShape") && !text.starts_with("CASCADE Topology"))
        return std::nullopt;
    return unreadCad(form("a BREP file"));
}

/// Assimp 5.2 has readers of these, which find nothing in any of them.
std::optional<Sentence> irrlicht(View head, const std::string&) {
    constexpr std::size_t kBeginning = 2048;
    const View beginning = head.substr(0, kBeginning);
    const std::string text =
        utf8OfUtf16(std::as_bytes(std::span(beginning))).value_or(std::string(beginning));
    if (!has(text, "<irr_scene") && !has(text, "irrlicht.sourceforge.net/IRRMESH")) return std::nullopt;
    return itIs(form("a file of Irrlicht, which is not read"), kAsGltfOrObj);
}

constexpr std::array kByContent{step, zip, oldFbx, blend, compound, iges, brep, irrlicht};

// Formats that are never read.

struct Signature {
    View bytes;         ///< with which the file begins
    const char* what;   ///< it is
    const char* remedy; ///< what to do
};

constexpr std::array kBinary{
    Signature{"\x1F\x8B"sv, form("a file packed by gzip"),
              form("unpack it (gunzip) and give the model inside")},
    Signature{"7z\xBC\xAF\x27\x1C"sv, form("a 7z archive"), kUnpack},
    Signature{"Rar!\x1A\x07"sv, form("a RAR archive"), kUnpack},
    Signature{"BZh"sv, form("a file packed by bzip2"), form("unpack it (bunzip2) and give the model inside")},
    Signature{"\xFD"
              "7zXZ\0"sv,
              form("a file packed by xz"), form("unpack it (unxz) and give the model inside")},
    Signature{"\x28\xB5\x2F\xFD"sv, form("a file packed by zstd"),
              form("unpack it (unzstd) and give the model inside")},
    Signature{"PXR-USDC"sv, form("a USD file, which is not read"), kFromUsd},
    Signature{"3D Geometry File Format"sv, form("a file of Rhino, which is not read"),
              form("export it as glTF, OBJ or STL from Rhino")},
    Signature{"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0"sv, form("a model of SketchUp, which is not read"),
              form("export it as glTF or Collada from SketchUp")},
    Signature{"AC10"sv, form("a DWG drawing, which is not read"),
              form("export it as FBX, STL or DXF from the CAD program")},
    Signature{"LASF"sv, form("a point cloud (LAS or LAZ), which has no surfaces"), kMeshOfIt},
    Signature{"ASTM-E57"sv, form("a point cloud (E57), which has no surfaces"), kMeshOfIt},
    Signature{"\x89HDF\r\n"sv, form("an HDF5 file, which is not read"), kAsGltfOrObj},
    Signature{"Ogawa"sv, form("an Alembic file, which is not read"), kAsGltfOrObj},
    Signature{"\x89PNG\r\n"sv, form("an image"), form("give a model")},
    Signature{"\xFF\xD8\xFF"sv, form("an image"), form("give a model")},
    Signature{"%PDF-"sv, form("a PDF document"), kAsGltfOrObj},
};

constexpr std::array kText{
    Signature{"#usda"sv, form("a USD file, which is not read"), kFromUsd},
    Signature{"#VRML V"sv, form("a VRML file, which is not read"), form("export the model as X3D or glTF")},
    Signature{"# .PCD"sv, form("a point cloud (PCD), which has no surfaces"), kMeshOfIt},
    Signature{"**ABCDEFGHIJKLMNOPQRSTUVWXYZ"sv, form("a Parasolid file of CAD surfaces, which are not read"),
              kFromCad},
    Signature{"version https://git-lfs.github.com/"sv, form("a pointer of Git LFS, not the model itself"),
              form("fetch the model (git lfs pull)")},
    Signature{"<!DOCTYPE html"sv, form("a web page, not a model"), kDownload},
    Signature{"<!doctype html"sv, form("a web page, not a model"), kDownload},
    Signature{"<html"sv, form("a web page, not a model"), kDownload},
};

std::optional<Sentence> matching(std::span<const Signature> table, View head) {
    for (const Signature& s : table)
        if (head.starts_with(s.bytes)) return itIs(s.what, s.remedy);
    return std::nullopt;
}

/// How a format that is read begins, and the endings that it has, the first one first.
struct Beginning {
    View bytes;
    std::array<const char*, 3> endings;
};

constexpr std::array kBeginnings{
    Beginning{"glTF"sv, {".glb", ".gltf", ".vrm"}},
    Beginning{"Kaydara FBX Binary"sv, {".fbx"}},
    Beginning{"; FBX"sv, {".fbx"}},
    Beginning{"ply\n"sv, {".ply"}},
    Beginning{"ply\r"sv, {".ply"}},
    Beginning{"xof 0"sv, {".x"}},
    Beginning{"AC3D"sv, {".ac", ".ac3d", ".acc"}},
    Beginning{"*3DSMAX_ASCIIEXPORT"sv, {".ase", ".ask"}},
    Beginning{"MS3D000000"sv, {".ms3d"}},
    Beginning{"ISO-10303-21"sv, {".ifc", ".step", ".stp"}},
    Beginning{"BLENDER"sv, {".blend"}},
    Beginning{"OFF\n"sv, {".off"}},
};

bool belongsTo(const Beginning& format, const std::string& ending) {
    return std::ranges::any_of(format.endings, [&](const char* e) { return e != nullptr && ending == e; });
}

} // namespace

std::optional<CadFormat> cadFormat(const std::filesystem::path& path) {
    const std::string head = headOfFile(path), ending = lowerCase(path.extension().string());
    if (const auto schema = stepSchema(head); schema && isCadSchema(*schema, ending)) return CadFormat::Step;
    if (iges(head, ending)) return CadFormat::Iges;
    if (brep(head, ending)) return CadFormat::Brep;
    return std::nullopt;
}

std::optional<Sentence> unreadFormat(const std::filesystem::path& path) {
    const std::string head = headOfFile(path), ending = lowerCase(path.extension().string());
    for (const auto& format : kByContent)
        if (auto sentence = format(head, ending)) return sentence;
    const bool packedBlend = ending == ".blend" && head.starts_with("\x1F\x8B");
    if (packedBlend) return std::nullopt; // which Assimp unpacks
    if (auto sentence = matching(kBinary, head)) return sentence;
    if (head.size() > 262 && View(head).substr(257, 5) == "ustar")
        return itIs(form("a tar archive"), kUnpack);
    return matching(kText, textBeginning(head));
}

std::optional<std::string> endingByContent(const std::filesystem::path& path) {
    const std::string head = headOfFile(path), ending = lowerCase(path.extension().string());
    const View text = textBeginning(head);
    for (const Beginning& format : kBeginnings) {
        if (text.starts_with(format.bytes))
            return belongsTo(format, ending) ? std::nullopt : std::optional<std::string>(format.endings[0]);
    }
    const bool xml = text.starts_with("<?xml"), json = text.starts_with("{");
    const View start = text.substr(0, 2048);
    if (xml && has(start, "<COLLADA") && ending != ".dae" && ending != ".xml") return ".dae";
    if (xml && has(start, "<X3D") && ending != ".x3d" && ending != ".xml") return ".x3d";
    if (json && has(text, "\"asset\"") && has(text, "\"version\"") && ending != ".gltf") return ".gltf";
    return std::nullopt;
}

void refuseMisnamed(const std::filesystem::path& path) {
    const auto ending = endingByContent(path);
    if (!ending) return;
    throw FileError(FailureKind::BadData, "",
                    say("its name does not fit its content; rename it so that it ends in {0}", *ending));
}

} // namespace rtcore
