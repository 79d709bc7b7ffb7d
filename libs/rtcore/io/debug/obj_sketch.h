/// A drawing in space as a Wavefront OBJ model: lines are thin bars with faces, so that every program shows
/// them.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace rtcore {

/// Grows in memory; what lies outside of the range of floats is left out.
class ObjSketch {
  public:
    /// `materials` is the name of the file that holds materials(), without white space.
    explicit ObjSketch(std::string_view materials);

    /// Starts an object of this colour (0..1), to which all shapes belong until the next.
    void object(std::string_view name, Colour colour);
    /// A prism of three sides around the line, `thickness` across; nothing where the ends coincide.
    void bar(Vec3 from, Vec3 to, float thickness);
    /// The twelve edges.
    void edges(const Box3& box, float thickness);
    void triangle(Vec3 a, Vec3 b, Vec3 c);
    /// Eight faces.
    void octahedron(Vec3 centre, float radius);

    const std::string& text() const { return text_; }
    const std::string& materials() const { return materials_; }

  private:
    std::uint64_t vertex(Vec3 p);

    std::string text_, materials_;
    std::uint64_t vertices_ = 0; ///< so far; OBJ counts from 1
};

} // namespace rtcore
