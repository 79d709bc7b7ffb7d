#include "rtcore/io/import/cad/face_mesh.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>

#include <utility>

namespace rtcore {

namespace {

Vec3 vecOf(const gp_XYZ& p) {
    return {static_cast<float>(p.X()), static_cast<float>(p.Y()), static_cast<float>(p.Z())};
}

} // namespace

void addFace(const TopoDS_Shape& shape, const TopLoc_Location& location, const LocalOrigin& origin,
             FaceMesh& mesh) {
    const TopoDS_Face& face = TopoDS::Face(shape);
    TopLoc_Location own;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, own);
    if (triangulation.IsNull()) return;
    const gp_Trsf toWorld = (location * own).Transformation(), ofSurface = location.Transformation();
    const bool reversed = face.Orientation() == TopAbs_REVERSED, mirrored = toWorld.IsNegative();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    BRepAdaptor_Surface surface(face, false);
    for (Standard_Integer i = 1; i <= triangulation->NbNodes(); ++i) {
        const gp_XYZ p = triangulation->Node(i).Transformed(toWorld).XYZ();
        mesh.positions.push_back(origin.local({p.X(), p.Y(), p.Z()}));
        Vec3 normal;
        if (triangulation->HasUVNodes()) {
            const gp_Pnt2d at = triangulation->UVNode(i);
            BRepLProp_SLProps properties(surface, at.X(), at.Y(), 1, 1e-9);
            if (properties.IsNormalDefined()) {
                const gp_Dir direction = properties.Normal().Transformed(ofSurface);
                normal = vecOf(direction.XYZ()) * (reversed ? -1.0F : 1.0F);
            }
        }
        mesh.normals.push_back(normal);
    }
    for (Standard_Integer i = 1; i <= triangulation->NbTriangles(); ++i) {
        Standard_Integer a = 0, b = 0, c = 0;
        triangulation->Triangle(i).Get(a, b, c);
        if (reversed != mirrored) std::swap(b, c);
        const auto at = [first](Standard_Integer node) {
            return first + static_cast<std::uint32_t>(node) - 1;
        };
        mesh.triangles.push_back({{at(a), at(b), at(c)}});
    }
}

} // namespace rtcore
