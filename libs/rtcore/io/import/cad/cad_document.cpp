#include "rtcore/io/import/cad/cad_document.h"

#include "rtcore/io/import/cad/alive_progress.h"
#include "rtcore/io/import/inspection/cut_off.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/platform/error.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace rtcore {

namespace {

[[noreturn]] void refuseCad(const std::filesystem::path& path, const char* format) {
    if (const auto cut = cutOff(path)) throw FileError(FailureKind::BadData, "", *cut);
    throw FileError(
        FailureKind::BadData, "",
        say("it is {0} of CAD surfaces, none of which can be read; export it as STL, 3MF or glTF from "
            "the CAD program",
            format));
}

template <typename Reader>
bool transfer(Reader& reader, const std::filesystem::path& path, Handle(TDocStd_Document) & document,
              const std::function<void()>& alive) {
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return false;
    alive();
    Handle(AliveProgress) progress = new AliveProgress(alive);
    return reader.Transfer(document, progress->Start());
}

bool readBrep(const std::filesystem::path& path, const Handle(TDocStd_Document) & document) {
    BRep_Builder builder;
    TopoDS_Shape shape;
    if (!BRepTools::Read(shape, path.c_str(), builder) || shape.IsNull()) return false;
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->AddShape(shape, false);
    return true;
}

} // namespace

Handle(TDocStd_Document)
    readCadDocument(const std::filesystem::path& path, const std::function<void()>& alive) {
    Message::DefaultMessenger()->ChangePrinters().Clear(); // standard output is the report's
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const std::optional<CadFormat> format = cadFormat(path);
    if (format == CadFormat::Step) {
        STEPCAFControl_Reader reader;
        Interface_Static::SetCVal("xstep.cascade.unit", "MM");
        if (!transfer(reader, path, document, alive)) refuseCad(path, form("a STEP file"));
    } else if (format == CadFormat::Iges) {
        IGESCAFControl_Reader reader;
        Interface_Static::SetCVal("xstep.cascade.unit", "MM");
        if (!transfer(reader, path, document, alive)) refuseCad(path, form("an IGES file"));
    } else if (!readBrep(path, document)) {
        refuseCad(path, form("a BREP file"));
    }
    return document;
}

} // namespace rtcore
