#include "rtserver/frames/kept_light.h"

#include "common/process/private_files.h"

#include "rtcore/io/light/content_hash.h"
#include "rtcore/io/light/light_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

using namespace std::chrono_literals;

constexpr auto kFirstFrame = 300ms;            ///< that the first frame may wait for its light
constexpr auto kApart = 10s;                   ///< between files that are written
constexpr auto kPatience = 5s;                 ///< at the end
constexpr std::uint32_t kSteps = 16;           ///< less was learned: not worth a file
constexpr std::uintmax_t kFolder = 500U << 20; ///< bytes that the folder may hold

/// The oldest go first.
void makeRoom(const std::filesystem::path& folder) {
    struct Kept {
        std::filesystem::file_time_type time;
        std::uintmax_t size;
        std::filesystem::path path;
    };
    std::vector<Kept> files;
    std::error_code error;
    for (const auto& each : std::filesystem::directory_iterator(folder, error)) {
        if (each.path().extension() != ".light" || !each.is_regular_file(error)) continue;
        files.push_back({each.last_write_time(error), each.file_size(error), each.path()});
    }
    std::ranges::sort(files, std::greater{}, &Kept::time);
    std::uintmax_t size = 0;
    for (const Kept& each : files) {
        size += each.size;
        if (size > kFolder) std::filesystem::remove(each.path, error);
    }
}

/// What went wrong; empty: nothing.
rtcore::Sentence problemOf(const std::function<void()>& write) {
    try {
        write();
        return {};
    } catch (const std::exception& failure) {
        return rtcore::say("indirect light is not kept: {0}", rtcore::sentenceOf(failure));
    }
}

} // namespace

std::filesystem::path lightFileOf(const std::filesystem::path& folder, const std::filesystem::path& scene) {
    rtcore::ContentHash hash;
    hash.add(std::string_view(scene.native()));
    constexpr std::size_t kMaxName = 64; // names of files have an end
    return folder / fmt::format("{}-{:016x}.light", scene.stem().string().substr(0, kMaxName), hash.value());
}

void KeptLight::sceneShown() {
    reading_.reset();
    written_ = 0;
    lit_.take(document_.revisions());
    settings_ = document_.frameSettings();
    const std::filesystem::path scene = document_.world().source;
    file_ = options_.lightCache ? lightFileOf(*options_.lightCache, scene) : std::filesystem::path();
    const bool named = std::exchange(first_, false) && options_.light;
    const std::filesystem::path from = named ? *options_.light : file_;
    std::error_code error;
    const bool off = settings_.indirect.mode != rtcore::IndirectMode::Live;
    if (off && named) messages_.warn(rtcore::lightIsUnused(from));
    if (off || from.empty() || (!named && !std::filesystem::exists(from, error))) return;
    reading_ = std::make_unique<DetachedTask<Found>>(
        [from, named, scene = document_.imagedScene(), tracer = document_.tracer(), settings = settings_] {
            Found found;
            try {
                const rtcore::LightKey key = rtcore::lightKeyOf(*scene, tracer->bounds(), settings);
                rtcore::LightFile file = rtcore::readLightFile(from, key);
                if (file.match == rtcore::LightMatch::Same)
                    found.light = std::move(file.light);
                else if (named)
                    found.problem =
                        rtcore::say("{0}: is the light of another scene; it is not used", from.string());
            } catch (const std::exception& failure) {
                found.problem = rtcore::sentenceOf(failure);
            }
            return found;
        });
    reading_->wait(kFirstFrame);
    takeRead();
}

void KeptLight::takeRead() {
    if (reading_ == nullptr || !reading_->done()) return;
    const Found found = std::exchange(reading_, nullptr)->take();
    if (!found.problem.empty()) messages_.warn(found.problem);
    using rtcore::Change;
    const bool other = lit_.take(document_.revisions())
                           .hasAny({Change::Scene, Change::Light, Change::Sky, Change::Material,
                                    Change::Visibility, Change::Section}) ||
                       !rtcore::sameLight(settings_, document_.frameSettings());
    if (!found.light || other) return;
    drawing_.beginLightWith(*found.light);
    written_ = found.light->frame;
}

void KeptLight::advance(bool idle) {
    if (!document_.ready()) return;
    takeRead();
    if (writing_ != nullptr && writing_->done()) {
        const rtcore::Sentence problem = std::exchange(writing_, nullptr)->take();
        writtenAt_ = Clock::now();
        if (!problem.empty()) {
            messages_.warn(problem);
            file_.clear(); // not again and again
        }
    }
    if (idle && writing_ == nullptr && Clock::now() >= writtenAt_ + kApart) write();
}

void KeptLight::leave(bool wait) {
    if (!document_.ready()) return;
    if (writing_ != nullptr) writing_->wait(kPatience);
    if (writing_ == nullptr || writing_->done()) write();
    if (wait && writing_ != nullptr) writing_->wait(kPatience);
}

bool KeptLight::worthWriting(std::uint32_t steps) const {
    return !file_.empty() && !document_.modified() && steps >= written_ + kSteps &&
           document_.settings().indirect.mode == rtcore::IndirectMode::Live;
}

void KeptLight::write() {
    const rtcore::IndirectLight* const light = drawing_.walkLight();
    if (light == nullptr || !worthWriting(light->steps())) return;
    written_ = light->steps();
    try {
        auto state = std::make_shared<const rtcore::IndirectState>(light->state());
        writing_ = std::make_unique<DetachedTask<rtcore::Sentence>>([file = file_, state,
                                                                     scene = document_.imagedScene(),
                                                                     tracer = document_.tracer(),
                                                                     settings = document_.frameSettings()] {
            return problemOf([&] {
                const std::filesystem::path folder = file.parent_path();
                if (!std::filesystem::exists(folder)) app::makePrivateFolder(folder.string());
                rtcore::writeLightFile(file, rtcore::lightKeyOf(*scene, tracer->bounds(), settings), *state);
                rtcore::removeForgottenFiles(folder);
                makeRoom(folder);
            });
        });
    } catch (const std::bad_alloc&) { // then that of later
    }
}

} // namespace rtserver
