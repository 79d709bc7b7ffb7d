/// Glass with a rough surface: at each point one of its facets, chosen at random, divides, mirrors and bends
/// the light in place of the surface. (Walter, Marschner, Li and Torrance 2007, "Microfacet Models for
/// Refraction through Rough Surfaces")
#pragma once

#include "rtcore/sampling/sample_id.h"
#include "rtcore/shading/surface/surface.h"

namespace rtcore {

/// It is glass, and its surface is rough somewhere.
bool isFrosted(const Material& m);

/// The alpha of its facets (GGX) at a hit: below kMinAlpha it is smooth there.
float facetAlpha(const Scene& scene, bool textures, const Hit& hit);

/// Takes a facet that the viewer sees, as `point` chooses it, for the shading normal: by it splitLight(),
/// mirrored rays and rayBehind() go then. Light that others mask is taken to leave as if they did not, so
/// that none is lost.
void takeFacet(float alpha, SquarePoint point, Surface& s);

} // namespace rtcore
