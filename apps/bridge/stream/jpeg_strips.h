/// One JPEG of strips that can be decoded on their own, so that a browser decodes a frame on several cores at
/// once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace bridge {

/// Rows of a strip of an image of this width: full rows of blocks (16 pixels high), some 2^18 pixels. An
/// image of at most this height is one strip.
int stripHeight(int width);

/// Joins JPEGs that lie below each other into one of `height` rows. Each is what libjpeg-turbo writes:
/// baseline, one scan, no restarts; all have the same width, quality and subsampling, and all but the last
/// have stripHeight() rows. Between two stands a restart marker (ITU-T T.81, E.1.4), before which nothing is
/// needed to decode what comes after it.
std::vector<std::uint8_t> joinStrips(std::span<const std::span<const std::uint8_t>> strips, int height);

} // namespace bridge
