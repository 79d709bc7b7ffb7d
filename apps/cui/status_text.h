/// A server's status as text, for people and for programs.
#pragma once

#include "ipc/endpoint/instances.h"
#include "ipc/layout/status.h"

#include <cstdint>
#include <span>
#include <string>

namespace cui {

/// One line "name: value" for each figure.
std::string statusText(const std::string& instance, std::int64_t process, const ipc::Status& status);
/// One JSON object, one line.
std::string statusJson(const std::string& instance, std::int64_t process, const ipc::Status& status);
/// The few numbers that `watch` prints, on one line.
std::string statusLine(const ipc::Status& status);

/// One line for each server; nothing when there is none.
std::string listText(std::span<const ipc::Instance> instances);
/// One JSON array, one line.
std::string listJson(std::span<const ipc::Instance> instances);

} // namespace cui
