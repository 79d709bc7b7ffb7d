/// A colour, a gradient or another image, shown behind an image that leaves its background out. It is of the
/// display, neither exposed nor tone mapped, and lights nothing.
#pragma once

#include "rtcore/scene/image.h"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rtcore {

class Backdrop {
  public:
    /// From one colour at the top of images to another at the bottom, evenly in sRGB.
    Backdrop(Rgba8 top, Rgba8 bottom) : top_(top), bottom_(bottom) {}
    /// An image, scaled so that it just covers those that it is put behind, and its middle is theirs; its
    /// own alpha does not count. Not empty.
    explicit Backdrop(LdrImage image) : image_(std::move(image)) {}
    /// The pattern by which programs show where an image is transparent.
    static Backdrop chequers();

    /// Puts it behind an image of straight alpha, which is opaque then. Colours are mixed as light is.
    void paintBehind(LdrImage& image);

  private:
    void fillRow(int y, int width, int height);
    void scaleTo(int width, int height);

    Rgba8 top_, bottom_;
    bool chequered_ = false;
    LdrImage image_, scaled_;
    std::vector<Rgba8> row_;
};

/// "#rrggbb", or two of them with a comma between: the top's and the bottom's. None where it is no such text.
std::optional<Backdrop> parseBackdropColours(std::string_view text);

} // namespace rtcore
