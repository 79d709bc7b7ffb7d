/// The surfaces that a wave of rays found, one array for each value, so that vector code lights them.
#pragma once

#include "rtcore/kernels/arrays_of_3.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/wave_memory.h"
#include "rtcore/scene/mesh.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// A point off all surfaces, and the side of it that is looked at.
struct WhitePoint {
    Vec3 position;
    Vec3 normal; ///< unit
};

/// One element for each ray of the wave, and room for whole blocks of kWaveBlock. One for each thread; keeps
/// its memory.
class SurfaceWave {
  public:
    /// Fills everything down to `diffuseBrdf` from the hits of `rays` (directions of unit length). Of points
    /// with a trait of kNotPlain, `diffuseBrdf` and `shadingNormal` are those of the material and mesh
    /// without textures; `notPlain()` lists them in ascending order.
    void fill(const Mesh& mesh, const MaterialTable& materials, const RayWave& rays, const HitWave& hits);

    /// The same of points of white matte paper, of an albedo of 1, in place of hits: each is seen straight
    /// on.
    void fillWhite(std::span<const WhitePoint> points, const MaterialTable& materials);
    /// After fill(): all that was hit is such paper, flat and on the side of the viewer.
    void whiten(const MaterialTable& materials);

    /// The points of another wave at these indices, without the list of those that are not plain, and without
    /// `specular` and `contribution`.
    void gather(const SurfaceWave& from, std::span<const std::uint32_t> points,
                const MaterialTable& materials);

    std::size_t size() const { return size_; }
    std::span<const std::uint32_t> notPlain() const { return {notPlain_.data(), notPlainCount_}; }

    std::uint32_t* traits = nullptr;   ///< material_table.h; 0 where the ray missed
    std::uint32_t* material = nullptr; ///< index; undefined where the ray missed, as is all that follows
    ArraysOf3 position;
    float* clearance = nullptr; ///< as in Surface
    ArraysOf3 geometricNormal;  ///< unit, on the side of the viewer
    ArraysOf3 shadingNormal;    ///< unit, as in Surface
    ArraysOf3 toViewer;         ///< unit
    /// f_r of the diffuse lobe, albedo / pi. Where traits have kMetallic it is the base colour / pi until the
    /// light is divided (light_division.h).
    ArraysOf3 diffuseBrdf;
    /// Set there, where traits have kMetallic: factors on the GGX lobe, the albedo of all gloss beside what
    /// is mirrored, which part of it is scattered further and with what shape, and alpha (MetallicLobes).
    /// Null where no material is of that model.
    ArraysOf3 straight, grazing, gloss, further, furtherShape;
    float* alpha = nullptr;
    /// Set with these: the coat's CoatLobe, its albedo without what is mirrored. Of points without one 0, 0
    /// and 1. Null where no material has one.
    float *coat = nullptr, *coatAlbedo = nullptr, *coatAlpha = nullptr;
    ArraysOf3 tint; ///< factor on the Phong lobes; null where no material has a texture of it
    /// Throughput of the path up to here: the fraction of scattered light that reaches the sample; of all
    /// light that leaves the point until it is divided.
    ArraysOf3 weight;
    ArraysOf3 specular; ///< weight of the mirrored ray, where traits have kSpecular
    /// Scratch of one step at a time: the radiance that it adds to the sample of each ray. In turn those are
    /// the lights that rays meet, emission, ambient light or the sky's, and each light or next event, first
    /// unshadowed and then as far as it arrives. SampleSums::add() takes it; the next step overwrites it.
    ArraysOf3 contribution;

  private:
    void resize(std::size_t count, const MaterialTable& materials);
    void clearTint(const MaterialTable& materials);

    std::size_t size_ = 0;
    WaveMemory memory_;
    std::vector<std::uint32_t> traits_, materials_;
    std::vector<std::uint32_t> notPlain_; ///< the first notPlainCount_ count
    std::size_t notPlainCount_ = 0;
};

} // namespace rtcore
