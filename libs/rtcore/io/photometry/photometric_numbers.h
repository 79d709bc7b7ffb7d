/// Lines and numbers of photometric files, and what is said where they are wrong.
#pragma once

#include "rtcore/platform/sentence.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// The lines of a text one by one, without white space around them.
class PhotometricLines {
  public:
    PhotometricLines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

    /// Nothing behind the last one.
    std::optional<std::string_view> next();
    /// Throws FileError BadData for the line that was read last.
    [[noreturn]] void fail(const Sentence& message) const;
    [[noreturn]] void failCutOff(const char* wanted) const;

    /// `words` as a finite number of at most 10^9 in size. `wanted`: a form that says what it is, for errors.
    double number(std::string_view words, const char* wanted) const;

  private:
    std::string_view rest_;
    std::string name_;
    int line_ = 0;
};

struct NumberRange {
    double min = -1e9, max = 1e9;
    bool whole = false;
};
/// Of what intensities are multiplied by, and of them themselves.
inline constexpr NumberRange kFactorRange{1e-9, 1e9}, kIntensityRange{0, 1e9};
/// Refuses a number outside of it.
void checkNumber(const PhotometricLines& lines, double number, const char* wanted, const NumberRange& range);

/// Pairs of angles in a file, at most.
inline constexpr std::size_t kMaxIntensities = 200'000;
inline constexpr double kMaxGammas = 2000, kMaxPlanes = 2000;
void checkCounts(const PhotometricLines& lines, std::size_t gammas, std::size_t planes);

/// Refuses the next angle of a list unless it is within the range and above the one before.
void checkAngle(const PhotometricLines& lines, const std::vector<double>& before, double angle,
                const NumberRange& range);
/// Refuses what stands behind the last intensity.
[[noreturn]] void failBehindLast(const PhotometricLines& lines, std::string_view more);
/// Refuses a file without any light.
void checkLit(const PhotometricLines& lines, const std::vector<double>& candela);

} // namespace rtcore
