/// The meanings of the words in capitals in commands, for completion by shells.
#pragma once

#include "common/cli/options.h"

#include <vector>

namespace cui {

std::vector<app::Operand> operands();

/// Names of the servers that run.
std::vector<std::string> suggestInstances(std::span<const std::string> words);

/// Keys with names of more than one letter.
std::vector<std::string> suggestKeys(std::span<const std::string> words);

/// Actions that keys can be bound to.
std::vector<std::string> suggestActions(std::span<const std::string> words);

} // namespace cui
