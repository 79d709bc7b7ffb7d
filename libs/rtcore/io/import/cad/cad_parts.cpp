#include "rtcore/io/import/cad/cad_parts.h"

#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/platform/error.h"

#include <NCollection_DataMap.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <TDF_LabelMapHasher.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace rtcore {

namespace {

constexpr int kMaxDepth = 200;

std::string nameOf(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
    const TCollection_ExtendedString& wide = name->Get();
    std::string text(static_cast<std::size_t>(wide.LengthOfCString()) + 1, '\0');
    Standard_PCharacter room = text.data();
    const Standard_Integer length = wide.ToUTF8CString(room);
    text.resize(static_cast<std::size_t>(length));
    return text;
}

/// How many parts and faces the assemblies hold, each as often as it is named.
class PartCount {
  public:
    explicit PartCount(const Handle(XCAFDoc_ShapeTool) & shapes) : shapes_(shapes) {}

    std::optional<ExpandedCount> count() {
        TDF_LabelSequence labels;
        shapes_->GetFreeShapes(labels);
        std::vector<std::size_t> roots;
        for (const TDF_Label& label : labels) roots.push_back(numberOf(label));
        for (std::size_t i = 0; i < known_.size(); ++i) addContent(i);
        return graph_.count(roots);
    }

  private:
    std::size_t numberOf(const TDF_Label& label) {
        TDF_Label shape = label;
        XCAFDoc_ShapeTool::GetReferredShape(label, shape);
        if (const Standard_Integer* const known = numbers_.Seek(shape))
            return static_cast<std::size_t>(*known);
        const std::size_t number = graph_.addNode();
        numbers_.Bind(shape, static_cast<Standard_Integer>(number));
        known_.push_back(shape);
        return number;
    }

    void addContent(std::size_t number) {
        const TDF_Label shape = known_[number];
        if (XCAFDoc_ShapeTool::IsAssembly(shape)) {
            TDF_LabelSequence components;
            XCAFDoc_ShapeTool::GetComponents(shape, components);
            for (const TDF_Label& component : components) graph_.addChild(number, numberOf(component));
            return;
        }
        ExpandedCount own{1, 0, 0};
        const TopoDS_Shape of = XCAFDoc_ShapeTool::GetShape(shape);
        if (!of.IsNull())
            for (TopExp_Explorer at(of, TopAbs_FACE); at.More(); at.Next()) ++own.triangles;
        graph_.own(number) = own;
    }

    const Handle(XCAFDoc_ShapeTool) & shapes_;
    InstanceGraph graph_;
    NCollection_DataMap<TDF_Label, Standard_Integer, TDF_LabelMapHasher> numbers_;
    std::vector<TDF_Label> known_; ///< by their numbers
};

class PartWalk {
  public:
    explicit PartWalk(const Handle(TDocStd_Document) & document)
        : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
          colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

    std::vector<CadPart> read(std::uint64_t memoryLimit) {
        const auto count = PartCount(shapes_).count();
        if (!count)
            throw FileError(FailureKind::BadData, "", say("its assemblies hold themselves; export it again"));
        refuseTooMuch(*count, memoryLimit);
        TDF_LabelSequence labels;
        shapes_->GetFreeShapes(labels);
        for (const TDF_Label& label : labels) visit(label, {}, "", {}, 0);
        return std::move(parts_);
    }

  private:
    std::optional<CadPaint> paintOf(const TDF_Label& label) const {
        for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
            Quantity_ColorRGBA c;
            if (!colours_->GetColor(label, type, c)) continue;
            const Quantity_Color& rgb = c.GetRGB();
            return CadPaint{{static_cast<float>(rgb.Red()), static_cast<float>(rgb.Green()),
                             static_cast<float>(rgb.Blue())},
                            c.Alpha()};
        }
        return std::nullopt;
    }

    void visit(const TDF_Label& label, const TopLoc_Location& above, const std::string& path,
               std::optional<CadPaint> paint, int depth) {
        if (depth > kMaxDepth)
            throw FileError(FailureKind::BadData, "",
                            say("its assemblies are deeper than {0}; export it again", kMaxDepth));
        TDF_Label shape = label;
        const TopLoc_Location location = above * XCAFDoc_ShapeTool::GetLocation(label);
        const bool isInstance = XCAFDoc_ShapeTool::GetReferredShape(label, shape);
        // That of an instance counts before that of what it is of, and this before that of the assembly.
        if (const auto ofShape = paintOf(shape)) paint = ofShape;
        if (const auto own = paintOf(label)) paint = own;
        std::string name = nameOf(shape);
        if (name.empty() && isInstance) name = nameOf(label);
        const std::string all = path.empty() || name.empty() ? path + name : path + "/" + name;
        if (!XCAFDoc_ShapeTool::IsAssembly(shape)) {
            addPart(shape, isInstance ? location : above, all, paint);
            return;
        }
        TDF_LabelSequence components;
        XCAFDoc_ShapeTool::GetComponents(shape, components);
        for (const TDF_Label& component : components)
            visit(component, isInstance ? location : above, all, paint, depth + 1);
    }

    void addPart(const TDF_Label& label, const TopLoc_Location& location, const std::string& name,
                 std::optional<CadPaint> paint) {
        CadPart part{name, XCAFDoc_ShapeTool::GetShape(label), location, {}};
        if (part.shape.IsNull()) return;
        // Faces and solids inside may have colours of their own; those of faces count.
        std::vector<CadPaint> paints;
        TopTools_DataMapOfShapeInteger paintOfFace;
        TDF_LabelSequence inside;
        XCAFDoc_ShapeTool::GetSubShapes(label, inside);
        for (const bool faces : {false, true}) {
            for (const TDF_Label& each : inside) {
                const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(each);
                const auto own = shape.IsNull() ? std::nullopt : paintOf(each);
                if (!own || (shape.ShapeType() == TopAbs_FACE) != faces) continue;
                paints.push_back(*own);
                for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
                    paintOfFace.Bind(at.Current(), static_cast<Standard_Integer>(paints.size() - 1));
            }
        }
        for (TopExp_Explorer at(part.shape, TopAbs_FACE); at.More(); at.Next()) {
            const Standard_Integer* const own = paintOfFace.Seek(at.Current());
            part.faces.push_back(
                {at.Current(), own != nullptr ? paints[static_cast<std::size_t>(*own)] : paint});
        }
        if (!part.faces.empty()) parts_.push_back(std::move(part));
    }

    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colours_;
    std::vector<CadPart> parts_;
};

} // namespace

std::vector<CadPart> cadPartsOf(const Handle(TDocStd_Document) & document, std::uint64_t memoryLimit) {
    return PartWalk(document).read(memoryLimit);
}

} // namespace rtcore
