/// Points of a model that a pointer catches: corners and edges before faces.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/scene/scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rtcore {

enum class SnapKind : std::uint8_t { Corner, Middle, Edge, Face };
inline constexpr std::array<std::string_view, 4> kSnapKinds{"corner", "middle", "edge", "face"};

struct Snap {
    SnapKind kind = SnapKind::Face;
    Vec3 point;             ///< scene units
    Vec3 normal;            ///< of the surface that is seen there: geometric, of unit length, to the viewer
    std::uint32_t triangle; ///< of that
};

/// At the point (x, y) of the image, in pixels: a corner no farther than `reach` pixels from it, else the
/// middle of an edge, else the nearest point of one, else the surface itself. Edges are those of isSharp();
/// corners are where they meet or bend. What something hides, or sections took away, is not caught. Nothing:
/// the pointer is at no surface. `shown` meets what is seen of the scene. Takes time of all triangles, some
/// 10 ms for a million.
std::optional<Snap> snapAt(const Scene& scene, const RayTracer& shown, const CameraRays& camera, float x,
                           float y, float reach);

/// Where the image shows it, in pixels; nothing for what lies behind a perspective camera.
std::optional<std::array<double, 2>> pixelOf(const CameraRays& camera, Vec3 point);

} // namespace rtcore
