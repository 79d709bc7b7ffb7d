#include "rtcore/post/net_report.h"

#include "rtcore/post/error_text.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/core.h>

namespace rtcore {

std::string textOf(const NetReport& report, DenoiseNet net) {
    if (!report.ran) return "";
    RenderSettings settings;
    settings.denoise.net = net;
    std::string text = "denoised by " + settingText(getSetting(settings, "denoise.net"));
    if (!report.estimated) return text;
    text += (report.mixed ? " and mixed: " : ": ") + errorText(report.error, report.largestError);
    if (report.dots > 0)
        text += fmt::format("; {} bright dots, {:.2g} % of the light, were kept from the net", report.dots,
                            100 * report.lightOfDots);
    return text;
}

} // namespace rtcore
