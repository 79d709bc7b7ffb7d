/// The answer to `measure light`, for people.
#pragma once

#include <QString>

#include <optional>

namespace gui {

/// A number with its standard error, and how many decimals are worth showing.
struct MeasuredNumber {
    double value = 0, error = 0;
    int decimals = 0;
    /// Of the value; of a value of 0 all or nothing.
    double relativeError() const;
};

struct LightReading {
    std::optional<MeasuredNumber> illuminance; ///< lx; nothing where no surface is seen
    std::optional<MeasuredNumber> luminance;   ///< cd/m^2
    QString unitless; ///< which of the light has no absolute unit, as the server says it
};

/// Empty where the answer is none.
LightReading lightReadingOf(const QString& answer);
/// "512 lx ± 3" and so on, a line each, in the user's language; empty for an empty reading.
QString lightText(const LightReading& reading);

} // namespace gui
