/// One moment of a long job as text: for a terminal, for a log, for a program.
#pragma once

#include <optional>
#include <string>

namespace app {

struct ProgressState {
    std::string phase;
    std::optional<double> fraction;    ///< 0..1 of the phase; when frames are rendered, of all of them
    int frame = 0;                     ///< 1..frames; 0 = the phase has no frames
    int frames = 0;                    ///< that this run renders
    std::optional<double> secondsLeft; ///< estimate
};

/// "rendering 3/10 [#####     ]  48% 1:07 left", at most `columns` - 1 characters, so that a terminal does
/// not wrap.
std::string barText(const ProgressState& state, int columns);

/// "rendering frame 3 of 10: 48%, 1:07 left".
std::string plainText(const ProgressState& state);

/// {"phase":"rendering","fraction":0.48,"frame":3,"frames":10,"secondsLeft":67.2}, without a line end. All
/// five names are always there; what is not known, or no number, is null.
std::string jsonText(const ProgressState& state);

/// "0:07", "12:34", "1:02:03"; rounded up.
std::string durationText(double seconds);

} // namespace app
