#include "rtcore/motion/world_frame.h"

#include <cmath>

namespace rtcore {

namespace {

Vec3d widen(Vec3 v) { return {double{v.x}, double{v.y}, double{v.z}}; }
Vec3 narrow(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

} // namespace

WorldFrame::WorldFrame(Vec3 up, double metresPerUnit) : up_(normalize(widen(up))), scale_(metresPerUnit) {
    if (!(length(up_) > 0.5)) up_ = {0, 1, 0};
    const Vec3d side = std::fabs(up_.x) > 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    right_ = normalize(side - up_ * dot(side, up_));
    ahead_ = cross(up_, right_);
}

Vec3d WorldFrame::turn(Vec3 d) const {
    const Vec3d v = widen(d);
    return {dot(v, right_), dot(v, ahead_), dot(v, up_)};
}
Vec3 WorldFrame::turnBack(Vec3d d) const { return narrow(right_ * d.x + ahead_ * d.y + up_ * d.z); }
Vec3d WorldFrame::toMetres(Vec3 p) const { return turn(p) * scale_; }
Vec3 WorldFrame::toScene(Vec3d p) const { return turnBack(p * (1 / scale_)); }

} // namespace rtcore
