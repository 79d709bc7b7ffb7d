/// Which of the vector instruction sets that the kernels were compiled for is used. All give the same bits;
/// forcing one is for tests, measurements and doubts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// Names of those that this processor has, fastest first: "avx512", "avx2", "sse4", "neon"; "scalar" is
/// always the last.
std::vector<std::string> instructionSets();

/// The one in use: the fastest, unless the environment variable RT_ISA or useInstructionSet() says otherwise.
std::string instructionSet();

/// Makes all vector code that is chosen from now on use `name`, one of instructionSets(), or the fastest for
/// "auto". Returns false, and changes nothing, for any other name. Not to be called while anything renders.
bool useInstructionSet(std::string_view name);

/// Takes RT_ISA from the environment. Throws std::invalid_argument when it names no instruction set of this
/// processor. Called by programs at their start.
void useInstructionSetOfEnvironment();

} // namespace rtcore
