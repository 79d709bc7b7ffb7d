/// A room of long narrow triangles: planks, blinds over long sills, shelves; with mirrors, a glass ball and
/// furniture between them that makes trees cut the room up. Rays that leave such triangles are the hardest to
/// answer alike in all trees (docs/decisions/0011-distances-in-doubt.md).
#pragma once

#include "support/random_numbers.h"
#include "support/small_scene.h"

#include <cstdint>

namespace test {

struct SlatRoomOptions {
    rtcore::Vec3 corner; ///< of the least coordinates; the floor is at its y
    float length = 2560; ///< of the room and its slats, along x
    float slat = 3.84F;  ///< width of slats
    std::uint64_t seed = 1;
};

class SlatRoom {
  public:
    explicit SlatRoom(const SlatRoomOptions& options) : options_(options), random_(options.seed) {}

    rtcore::Scene build() {
        addMaterials();
        addShell();
        addPlanks();
        for (const float height : {0.28F, 0.62F}) addWindow(height * kHeight);
        addShelves();
        addFurniture();
        return builder_.finish();
    }

  private:
    using Vec3 = rtcore::Vec3;

    static constexpr float kHeight = 0.35F, kDepth = 0.5F; ///< of the room, for a length of 1

    /// The point at these fractions of the length.
    Vec3 at(float x, float y, float z) const { return options_.corner + Vec3{x, y, z} * options_.length; }
    float anywhere(float lo, float hi) { return random_.number(lo, hi); }

    void addMaterials() {
        rtcore::Material lacquer = matte(0.5F);
        lacquer.mirror = {0.3F, 0.3F, 0.3F};
        lacquer.fresnel = 1;
        rtcore::Material satin = matte(0.6F);
        satin.specular = {0.2F, 0.2F, 0.2F};
        satin.shininess = 30;
        rtcore::Material pane = glass();
        pane.transmission = {0.7F, 0.9F, 0.8F};
        lacquered_ = builder_.material(lacquer);
        satin_ = builder_.material(satin);
        matte_ = builder_.material(matte(0.8F));
        glass_ = builder_.material(pane);
    }

    /// A rectangle along x, seen from the side to which `across` turns x.
    void addStrip(Vec3 start, float length, Vec3 across, std::uint32_t material) {
        const Vec3 along{length, 0, 0};
        builder_.quad(start, start + across, start + along + across, start + along, material);
    }

    void addShell() {
        const Vec3 lo = at(0, 0, 0), hi = at(1, kHeight, kDepth);
        builder_.quad({lo.x, lo.y, lo.z}, {lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, lo.y, lo.z}, matte_);
        builder_.quad({lo.x, hi.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z}, matte_);
        builder_.quad({lo.x, lo.y, lo.z}, {lo.x, hi.y, lo.z}, {lo.x, hi.y, hi.z}, {lo.x, lo.y, hi.z}, matte_);
        builder_.quad({hi.x, lo.y, lo.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, hi.y, lo.z}, satin_);
        builder_.quad({lo.x, lo.y, hi.z}, {lo.x, hi.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, lo.y, hi.z}, matte_);
    }

    /// Planks of a raised floor, side by side in one plane.
    void addPlanks() {
        const Vec3 start = at(0, 0.01F, 0.05F);
        for (int i = 0; i < 60; ++i) {
            const float z = start.z + static_cast<float>(i) * options_.slat;
            addStrip({start.x, start.y, z}, options_.length, {0, 0, options_.slat},
                     i % 3 == 0 ? lacquered_ : satin_);
        }
    }

    /// A sill, and level and tilted slats over it.
    void addWindow(float height) {
        const float width = options_.slat;
        const Vec3 sill = at(0, height, 0.03F);
        addStrip(sill, options_.length, {0, 0, width}, lacquered_);
        addStrip(sill + Vec3{0, -width, width}, options_.length, {0, width, 0}, satin_);
        for (int i = 1; i <= 24; ++i) {
            const float tilt = i <= 16 ? 0 : width * 0.1F * static_cast<float>(i - 16);
            const Vec3 up{0, width * 1.2F * static_cast<float>(i), 0};
            addStrip(sill + up, options_.length, {0, tilt, width}, i % 2 == 0 ? lacquered_ : satin_);
        }
    }

    void addShelves() {
        for (int i = 0; i < 12; ++i) {
            const float start = anywhere(0, 0.6F), length = anywhere(0.2F, 0.4F);
            const Vec3 board = at(start, kHeight * anywhere(0.1F, 0.9F), kDepth * anywhere(0.3F, 0.95F));
            addStrip(board, length * options_.length, {0, 0, options_.slat},
                     i % 2 == 0 ? lacquered_ : satin_);
        }
    }

    void addFurniture() {
        for (int i = 0; i < 30; ++i) {
            const Vec3 lo = at(anywhere(0, 0.95F), 0.01F, anywhere(0.02F, kDepth * 0.9F));
            const Vec3 size{anywhere(0.005F, 0.04F), anywhere(0.01F, kHeight * 0.8F),
                            anywhere(0.005F, 0.03F)};
            builder_.box(lo, lo + size * options_.length, i % 3 == 0 ? lacquered_ : matte_);
        }
        for (int i = 0; i < 4; ++i) {
            const Vec3 centre = at(anywhere(0.1F, 0.9F), kHeight * anywhere(0.3F, 0.7F), kDepth * 0.3F);
            builder_.sphere(centre, 0.03F * options_.length, 6, i % 2 == 0 ? glass_ : lacquered_);
        }
    }

    SlatRoomOptions options_;
    Random random_;
    SceneBuilder builder_;
    std::uint32_t lacquered_ = 0, satin_ = 0, matte_ = 0, glass_ = 0;
};

} // namespace test
