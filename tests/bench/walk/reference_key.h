/// By what references in files are known again: everything that they are made from, but not the program that
/// made them.
#pragma once

#include "bench/walk/walk_options.h"

#include "rtcore/scene/camera.h"
#include "rtcore/settings/settings_table.h"

#include <cstdint>
#include <span>
#include <string>

namespace bench {

/// The walk's scene: its name, time of change, size and light. Files that it names do not count.
std::string sceneKey(const WalkOptions& options);

std::uint64_t referenceKey(const std::string& scene, const rtcore::Camera& camera,
                           std::span<const rtcore::SettingAssignment> settings);

} // namespace bench
