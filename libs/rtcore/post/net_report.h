/// A net's report on an image.
#pragma once

#include "rtcore/settings/render_settings.h"

#include <cstddef>
#include <string>

namespace rtcore {

struct NetReport {
    bool ran = false;       ///< else nothing below counts
    bool estimated = false; ///< by halves of the samples; else no error is known, and no dots were looked for
    bool mixed = false;     ///< with the sampled image
    float error = 0;        ///< of the shown image, in codes of 255: EstimatedError::all (net_mix.h)
    float largestError = 0; ///< EstimatedError::largestBlock
    std::size_t dots = 0;   ///< bright dots that the net did not see, in both halves of the samples
    float lightOfDots = 0;  ///< 0..1: fraction of the image's light that they were
};

/// Such as "denoised by base and mixed: +-0.60 of 255, largest 2.1; 35 bright dots, 0.1 % of the light, were
/// kept from the net", in ASCII; "" where no net ran.
std::string textOf(const NetReport& report, DenoiseNet net);

} // namespace rtcore
