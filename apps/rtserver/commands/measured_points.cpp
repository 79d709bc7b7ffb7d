#include "rtserver/commands/measured_points.h"

#include "rtserver/commands/model_objects.h"

#include "rtcore/measures/extents.h"
#include "rtcore/plans/file_metres.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/settings/plain_text.h"

#include <vector>

namespace rtserver {

rtcore::Snap snapOf(const Call& call, std::size_t argument) {
    constexpr float kReach = 8; // pixels
    const rtcore::RenderSettings& settings = call.document().settings();
    const rtcore::CameraRays view(call.document().camera(), settings.width, settings.height);
    const auto snap =
        rtcore::snapAt(*call.document().scene(), *call.document().tracer(), view,
                       number(call[argument]) * static_cast<float>(settings.width),
                       number(call[argument + 1]) * static_cast<float>(settings.height), kReach);
    if (!snap) throw rtcore::Refusal("there is nothing to measure");
    return *snap;
}

rtcore::Vec3d filePointAt(const Call& call, std::size_t argument) {
    return {preciseNumber(call[argument]), preciseNumber(call[argument + 1]),
            preciseNumber(call[argument + 2])};
}

double metresPerUnitOf(const Call& call) { return rtcore::exactMetresPerUnit(*call.document().scene()); }

std::string guessLine(const Call& call) {
    const bool guessed = call.document().modelUnits().unitSaid == rtcore::Said::Guessed;
    return guessed ? "the unit is a guess; 'units' says it\n" : "";
}

double volumeNamed(const Call& call, std::span<const std::string> texts) {
    const rtcore::Scene& scene = *call.document().scene();
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    const std::vector<std::uint8_t> chosen = partsNamed(parts, texts);
    rtcore::ClosedPieces pieces(scene.model);
    double volume = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (chosen[i] == 0) continue;
        const auto own = rtcore::volumeOf(scene.model, parts[i].pieces, pieces);
        if (!own)
            throw rtcore::Refusal(
                rtcore::say("{0} is open: it has no volume", rtcore::inQuotes(parts[i].name)));
        volume += *own;
    }
    return volume;
}

} // namespace rtserver
