#include "rtcore/io/import/inspection/foreign_formats.h"

#include "rtcore/platform/files.h"

#include <fmt/core.h>

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
using namespace std::string_literals;
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

constexpr auto kUnpack = "unpack it and give the model inside";
constexpr auto kAsGltf = "export the model as glTF";
constexpr auto kAsGltfOrObj = "export the model as glTF or OBJ";
constexpr auto kFromCad = "export it as STL, 3MF or glTF from the CAD program";
constexpr auto kMeshOfIt = "make a mesh of it (CloudCompare, MeshLab) and save that as PLY";
constexpr auto kDownload = "download the file itself";

// Formats whose version or content decides whether they are read; nothing where they are.

std::optional<std::string> step(View head, const std::string& ending) {
    const View text = textBeginning(head);
    if (!text.starts_with("ISO-10303-21")) return std::nullopt;
    const std::size_t at = text.find("FILE_SCHEMA");
    View schema = at == View::npos ? View() : text.substr(at);
    schema = schema.substr(0, schema.find(';'));
    const std::size_t quote = schema.find('\'');
    schema = quote == View::npos ? View() : schema.substr(quote + 1);
    schema = schema.substr(0, schema.find('\''));
    if (schema.starts_with("IFC2X3")) return std::nullopt;
    if (schema.starts_with("IFC"))
        return fmt::format("it is a building in {}, which is not read; export it as IFC2x3 or as glTF",
                           schema.substr(0, 20));
    if (schema.empty() && ending == ".ifc") return std::nullopt;
    return "it is a STEP file of CAD surfaces, which are not read; "s + kFromCad;
}

std::optional<std::string> zip(View head, const std::string& ending) {
    if (!head.starts_with("PK\x03\x04"sv)) return std::nullopt;
    static constexpr std::array kPacked{".3mf"sv, ".kmz"sv, ".zae"sv, ".ifczip"sv, ".pk3"sv};
    if (std::ranges::find(kPacked, View(ending)) != kPacked.end()) return std::nullopt;
    if (ending == ".usdz" || has(head, ".usdc") || has(head, ".usda"))
        return "it is a USDZ file, which is not read; "s + kAsGltf;
    if (ending == ".fcstd" || has(head, "GuiDocument.xml"))
        return "it is a document of FreeCAD, which is not read; export it as STL, 3MF or glTF";
    if (has(head, "3D/3dmodel.model"))
        return "it is a 3MF file by its content; rename it so that it ends in .3mf";
    return "it is a zip archive; "s + kUnpack;
}

std::optional<std::string> oldFbx(View head, const std::string&) {
    int version = 0;
    if (head.starts_with("Kaydara FBX Binary  \0"sv) && head.size() >= 27) {
        std::memcpy(&version, head.data() + 23, sizeof version);
    } else if (textBeginning(head).starts_with("; FBX")) {
        version = numberBehind(head, "FBXVersion");
    }
    if (version <= 0 || version >= 7100) return std::nullopt;
    return fmt::format(
        "it is an FBX file of version {}.{}, from before 2011, which is not read; save it as FBX "
        "2011 or later, or as glTF",
        version / 1000, version % 1000 / 100);
}

/// Assimp knows their structure up to 3.3, packed by gzip, too; since 3.0 they are packed by zstd.
std::optional<std::string> blend(View head, const std::string& ending) {
    constexpr int kFirstUnread = 304;
    int version = 0;
    if (head.starts_with("BLENDER") && head.size() >= 12)
        std::from_chars(head.data() + 9, head.data() + 12, version);
    const bool packed = ending == ".blend" && head.starts_with("\x28\xB5\x2F\xFD");
    if (version < kFirstUnread && !packed) return std::nullopt;
    const std::string which = packed ? "" : fmt::format(" {}.{}", version / 100, version % 100);
    return fmt::format("it is a file of Blender{}, which is not read; export it as glTF from Blender", which);
}

std::optional<std::string> compound(View head, const std::string& ending) {
    if (!head.starts_with("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1")) return std::nullopt;
    if (ending == ".rvt" || ending == ".rfa")
        return "it is a model of Revit, which is not read; export it as IFC2x3, FBX or glTF from Revit";
    if (ending == ".max")
        return "it is a scene of 3ds Max, which is not read; export it as FBX or glTF from 3ds Max";
    return "it is a file of a CAD program, which is not read; export it as STL, 3MF or glTF from that "
           "program";
}

std::optional<std::string> iges(View head, const std::string&) {
    constexpr std::size_t kLine = 72; // then stand the section, S, and the number of the line
    if (head.size() < kLine + 8 || head[kLine] != 'S' || !has(head.substr(kLine + 1, 7), "1"))
        return std::nullopt;
    if (has(head.substr(0, kLine), "\n")) return std::nullopt;
    return "it is an IGES file of CAD surfaces, which are not read; "s + kFromCad;
}

constexpr std::array kByContent{step, zip, oldFbx, blend, compound, iges};

// Formats that are never read.

struct Signature {
    View bytes;         ///< with which the file begins
    const char* what;   ///< it is
    const char* remedy; ///< what to do
};

constexpr std::array kBinary{
    Signature{"\x1F\x8B"sv, "a file packed by gzip", "unpack it (gunzip) and give the model inside"},
    Signature{"7z\xBC\xAF\x27\x1C"sv, "a 7z archive", kUnpack},
    Signature{"Rar!\x1A\x07"sv, "a RAR archive", kUnpack},
    Signature{"BZh"sv, "a file packed by bzip2", "unpack it (bunzip2) and give the model inside"},
    Signature{"\xFD"
              "7zXZ\0"sv,
              "a file packed by xz", "unpack it (unxz) and give the model inside"},
    Signature{"\x28\xB5\x2F\xFD"sv, "a file packed by zstd", "unpack it (unzstd) and give the model inside"},
    Signature{"PXR-USDC"sv, "a USD file, which is not read", kAsGltf},
    Signature{"3D Geometry File Format"sv, "a file of Rhino, which is not read",
              "export it as glTF, OBJ or STL from Rhino"},
    Signature{"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0"sv, "a model of SketchUp, which is not read",
              "export it as glTF or Collada from SketchUp"},
    Signature{"AC10"sv, "a DWG drawing, which is not read",
              "export it as FBX, STL or DXF from the CAD program"},
    Signature{"LASF"sv, "a point cloud (LAS or LAZ), which has no surfaces", kMeshOfIt},
    Signature{"ASTM-E57"sv, "a point cloud (E57), which has no surfaces", kMeshOfIt},
    Signature{"\x89HDF\r\n"sv, "an HDF5 file, which is not read", kAsGltfOrObj},
    Signature{"Ogawa"sv, "an Alembic file, which is not read", kAsGltfOrObj},
    Signature{"\x89PNG\r\n"sv, "an image", "give a model"},
    Signature{"\xFF\xD8\xFF"sv, "an image", "give a model"},
    Signature{"%PDF-"sv, "a PDF document", kAsGltfOrObj},
};

constexpr std::array kText{
    Signature{"#usda"sv, "a USD file, which is not read", kAsGltf},
    Signature{"#VRML V"sv, "a VRML file, which is not read", "export the model as X3D or glTF"},
    Signature{"# .PCD"sv, "a point cloud (PCD), which has no surfaces", kMeshOfIt},
    Signature{"DBRep_DrawableShape"sv, "a BREP file of CAD surfaces, which are not read", kFromCad},
    Signature{"CASCADE Topology"sv, "a BREP file of CAD surfaces, which are not read", kFromCad},
    Signature{"**ABCDEFGHIJKLMNOPQRSTUVWXYZ"sv, "a Parasolid file of CAD surfaces, which are not read",
              kFromCad},
    Signature{"version https://git-lfs.github.com/"sv, "a pointer of Git LFS, not the model itself",
              "fetch the model (git lfs pull)"},
    Signature{"<!DOCTYPE html"sv, "a web page, not a model", kDownload},
    Signature{"<!doctype html"sv, "a web page, not a model", kDownload},
    Signature{"<html"sv, "a web page, not a model", kDownload},
};

std::optional<std::string> matching(std::span<const Signature> table, View head) {
    for (const Signature& s : table)
        if (head.starts_with(s.bytes)) return fmt::format("it is {}; {}", s.what, s.remedy);
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

std::optional<std::string> unreadFormat(const std::filesystem::path& path) {
    const std::string head = headOfFile(path), ending = lowerCase(path.extension().string());
    for (const auto& format : kByContent)
        if (auto sentence = format(head, ending)) return sentence;
    const bool packedBlend = ending == ".blend" && head.starts_with("\x1F\x8B");
    if (packedBlend) return std::nullopt; // which Assimp unpacks
    if (auto sentence = matching(kBinary, head)) return sentence;
    if (head.size() > 262 && View(head).substr(257, 5) == "ustar") return "it is a tar archive; "s + kUnpack;
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

} // namespace rtcore
