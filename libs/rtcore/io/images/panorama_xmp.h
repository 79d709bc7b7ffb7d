/// The mark by which programs and phones know a panorama: XMP of Google's GPano schema.
#pragma once

#include <string>

namespace rtcore {

/// An XMP packet (ISO 16684-1) for an equirectangular image that shows all directions.
std::string panoramaXmp(int width, int height);

} // namespace rtcore
