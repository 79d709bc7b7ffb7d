/// Forms of sentences (rtcore/platform/sentence.h) by which the window knows what it offers, or says in words
/// of its own.
#pragma once

namespace app::told {

// Effects of keys.
inline constexpr const char
    *kWalking = "walking",
    *kFlying = "flying",
    *kUnseenFloor = "nothing is below: walking on a floor at the model's lowest point that is not seen",
    *kNoRoom = "there is no room to stand here, or no floor below; move elsewhere first",
    *kBloomOn = "bloom on", *kBloomOff = "bloom off", *kLightOn = "light {0} on",
    *kLightOff = "light {0} off", *kNoLight = "there is no light {0}", *kEnvironment = "environment {0}",
    *kNoEnvironment = "there is no environment {0}";

// Decisions made for the user, and the commands that decide otherwise.
inline constexpr const char *kUpOffer = "{0} is taken for up ({1}); 'up {2}' turns the model",
                            *kUnitOffer = "{0} m are taken for a unit ({1}); 'units' sets another",
                            *kMaterialOffer = "{0}; 'material reset *' takes them as they are",
                            *kFillOffer =
                                "indirect light is rendered, and {0} stand in for it: it counts twice; "
                                "to switch them off: {1}";

} // namespace app::told
