#include "rtcore/io/import/assimp/assimp_parts.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/math/constants.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/simd/portable_math.h"

#include <assimp/camera.h>
#include <assimp/light.h>
#include <assimp/scene.h>
#include <assimp/version.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace rtcore {

namespace {

constexpr float kLargest = 1e16F;

Vec3 vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }
bool within(Vec3 v, float limit) {
    return std::fabs(v.x) <= limit && std::fabs(v.y) <= limit && std::fabs(v.z) <= limit;
}

/// Where the light or camera of this name stands.
Affine transformOf(const aiScene& scene, const NodeTransforms& transforms, const FormatQuirks& quirks,
                   const char* name) {
    const auto& root = scene.mRootNode;
    const auto at = transforms.find(quirks.lightsInRoot && root != nullptr ? root->mName.C_Str() : name);
    if (at != transforms.end()) return at->second;
    const auto ofFile = transforms.find(kNoNode);
    return ofFile != transforms.end() ? ofFile->second : Affine{};
}

/// The intensity of a light whose file knows colours and falloff only: so that a white surface in the middle
/// of the model, `d` away and facing the light, gets the colour that the classic formula colour / (c + l d +
/// q d^2) gives it; the classic diffuse albedo has no 1/pi.
float classicScale(const aiLight& light, float d) {
    const float c = std::max(light.mAttenuationConstant, 0.0F), l = std::max(light.mAttenuationLinear, 0.0F),
                q = std::max(light.mAttenuationQuadratic, 0.0F);
    const float falloff = c + l * d + q * d * d;
    return kPi * d * d / (falloff > 0 && std::isfinite(falloff) ? falloff : 1);
}

float intensityScale(const aiLight& light, const Light& placed, const FormatQuirks& quirks,
                     const Box3& bounds) {
    if (quirks.physicalLights) return 1;
    if (placed.kind == LightKind::Directional) return kPi;
    // Not nearer than a tenth of the model: a light in its very middle is not dark.
    const float nearest = std::max(bounds.diagonal() * 0.1F, 1e-6F);
    return classicScale(light, std::max(length(placed.position - bounds.centre()), nearest));
}

void setCone(const aiLight& light, const FormatQuirks& quirks, Light& out) {
    const float part = quirks.halfSpotAngles ? 1.0F : 0.5F;
    const float inner = std::isfinite(light.mAngleInnerCone) ? light.mAngleInnerCone * part : 0;
    float outer = std::isfinite(light.mAngleOuterCone) ? light.mAngleOuterCone * part : inner;
    if (quirks.oneSpotAngle) outer = inner;
    outer = std::clamp(outer, 0.01F, kPi / 2);
    out.cosOuter = portableCos(outer);
    // A soft edge of a tenth at least, so that the cone has no jagged rim.
    out.cosInner = portableCos(std::clamp(inner, 0.0F, outer * 0.9F));
}

/// False where it has no area.
bool setSides(const aiLight& light, const Affine& toWorld, Light& out) {
    const Vec3 up = vec(light.mUp), ahead = vec(light.mDirection);
    const Vec3 right = toWorld.vector(cross(ahead, up) * light.mSize.x);
    out.right = normalize(right - out.direction * dot(right, out.direction));
    if (out.right == Vec3{}) return false;
    out.width = length(right);
    out.height = length(toWorld.vector(normalize(up) * light.mSize.y));
    return out.width > 0 && out.height > 0 && out.width <= kLargest && out.height <= kLargest;
}

bool convert(const aiLight& light, const Affine& toWorld, const FormatQuirks& quirks, const Box3& bounds,
             Light& out) {
    switch (light.mType) {
    case aiLightSource_POINT:
        out.kind = LightKind::Point;
        break;
    case aiLightSource_DIRECTIONAL:
        out.kind = LightKind::Directional;
        break;
    case aiLightSource_SPOT:
        out.kind = LightKind::Spot;
        break;
    case aiLightSource_AREA:
        out.kind = LightKind::Rectangle;
        break;
    default:
        return false;
    }
    out.position = toWorld.point(vec(light.mPosition));
    if (out.kind != LightKind::Point) {
        out.direction = normalize(toWorld.vector(vec(light.mDirection)));
        if (out.direction == Vec3{}) return false;
    }
    if (out.kind == LightKind::Spot) setCone(light, quirks, out);
    if (out.kind == LightKind::Rectangle && !setSides(light, toWorld, out)) return false;
    if (!within(out.position, kLargest)) return false;
    const Colour colour{light.mColorDiffuse.r, light.mColorDiffuse.g, light.mColorDiffuse.b};
    out.intensity = colour * intensityScale(light, out, quirks, bounds);
    const Colour i = out.intensity;
    return i.r >= 0 && i.g >= 0 && i.b >= 0 && maxComponent(i) <= kLargest && !isBlack(i);
}

/// The aspect of the image that was framed. Without one in the file its vertical angle is meant for images of
/// any shape, and 4:3 is our choice.
float aspectOf(const aiCamera& camera) {
    constexpr float kMax = 1000;
    const float aspect = camera.mAspect;
    if (!(aspect > 0) || !std::isfinite(aspect)) return 4.0F / 3;
    return std::clamp(aspect, 1 / kMax, kMax);
}

/// The horizontal angle in degrees. Assimp documents it as half of the angle; its importers give all of it.
float horizontalFov(const aiCamera& camera, const FormatQuirks& quirks) {
    const float angle = camera.mHorizontalFOV;
    if (!(angle > 0) || !(angle < kPi)) return 60;
    float horizontal = angle;
    if (quirks.fovTimesAspect &&
        (aiGetVersionMajor() < 5 || (aiGetVersionMajor() == 5 && aiGetVersionMinor() < 3))) {
        // Without an aspect ratio it is the vertical angle.
        const float aspect = aspectOf(camera);
        const float vertical = camera.mAspect > 0 ? angle / aspect : angle;
        const float half = std::clamp(vertical / 2, 1e-3F, kPi / 2 - 1e-3F);
        horizontal = 2 * portableAtan2(portableSin(half) * aspect, portableCos(half));
    }
    return std::clamp(horizontal * (180 / kPi), 0.1F, 175.0F);
}

bool convert(const aiCamera& camera, const Affine& toWorld, const FormatQuirks& quirks, Camera& out) {
    out.eye = toWorld.point(quirks.cameraAtNode ? Vec3{} : vec(camera.mPosition));
    const Vec3 forward = quirks.cameraBackwards ? Vec3{0, 0, -1} : vec(camera.mLookAt);
    out.forward = normalize(toWorld.vector(forward));
    out.up = normalize(toWorld.vector(vec(camera.mUp)));
    if (!within(out.eye, kLargest) || out.forward == Vec3{}) return false;
    if (!(length(cross(out.forward, out.up)) > 1e-3F)) {
        out.up = std::fabs(out.forward.y) < 0.9F ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    }
    out.horizontalFov = horizontalFov(camera, quirks);
    const bool framed = camera.mAspect > 0 || quirks.fovTimesAspect;
    if (quirks.framedAspect && framed) out.aspect = aspectOf(camera);
    if (camera.mOrthographicWidth > 0 && camera.mOrthographicWidth <= kLargest / 2) {
        out.kind = CameraKind::Orthographic;
        out.orthographicWidth = 2 * camera.mOrthographicWidth; // Assimp's is half of it
    }
    return true;
}

} // namespace

void addLights(const aiScene& scene, const NodeTransforms& transforms, const FormatQuirks& quirks,
               const Box3& bounds, ModelBuffers& model, ImportReport& report) {
    for (unsigned i = 0; i < scene.mNumLights && scene.mLights != nullptr; ++i) {
        const aiLight* const light = scene.mLights[i];
        if (light == nullptr) continue;
        Light out;
        if (convert(*light, transformOf(scene, transforms, quirks, light->mName.C_Str()), quirks, bounds,
                    out)) {
            out.nameOffset = model.addName(light->mName.C_Str());
            model.lights.push_back(out);
        } else {
            addWarning(report,
                       say(import_forms::kLightLeftOut, std::string("'") + light->mName.C_Str() + "'"));
        }
    }
}

void addCameras(const aiScene& scene, const NodeTransforms& transforms, const FormatQuirks& quirks,
                ModelBuffers& model, ImportReport& report) {
    for (unsigned i = 0; i < scene.mNumCameras && scene.mCameras != nullptr; ++i) {
        const aiCamera* const camera = scene.mCameras[i];
        if (camera == nullptr) continue;
        Camera out;
        if (convert(*camera, transformOf(scene, transforms, quirks, camera->mName.C_Str()), quirks, out)) {
            out.nameOffset = model.addName(camera->mName.C_Str());
            model.cameras.push_back(out);
        } else {
            addWarning(report,
                       say(import_forms::kCameraLeftOut, std::string("'") + camera->mName.C_Str() + "'"));
        }
    }
}

} // namespace rtcore
