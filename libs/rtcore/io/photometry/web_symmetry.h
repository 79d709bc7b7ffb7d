/// The planes that a photometric file leaves out, since they mirror others.
#pragma once

#include "rtcore/scene/photometry.h"

namespace rtcore {

/// Fills up `web`, whose planes are those of a file: one alone (all are alike), over 90 degrees from 0 on
/// (both main planes mirror), over 180 (the plane of both ends mirrors), or all around, with or without the
/// last one. Returns whether they are one of these.
bool completeWeb(PhotometricWeb& web);

/// What a mirror shows of a complete one in which the plane C = 0 stands upright.
PhotometricWeb mirroredWeb(const PhotometricWeb& web);

} // namespace rtcore
