#include "gui/models/light_reading.h"

#include "gui/models/translated.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace gui {

namespace {

/// "512.3 lx, standard error 3.1"
std::optional<MeasuredNumber> numberOf(const QString& answer, const QString& name, const QString& unit) {
    const QRegularExpression line(
        QStringLiteral("^%1 ([0-9.]+) %2, standard error ([0-9.]+)$").arg(name, unit),
        QRegularExpression::MultilineOption);
    const QRegularExpressionMatch match = line.match(answer);
    if (!match.hasMatch()) return std::nullopt;
    const QString value = match.captured(1);
    const auto point = value.indexOf(QLatin1Char('.'));
    return MeasuredNumber{.value = value.toDouble(),
                          .error = match.captured(2).toDouble(),
                          .decimals = point < 0 ? 0 : static_cast<int>(value.size() - point - 1)};
}

QString textOf(const MeasuredNumber& number, const QString& unit) {
    const QLocale locale;
    return QStringLiteral("%1 %2 ± %3")
        .arg(locale.toString(number.value, 'f', number.decimals), unit,
             locale.toString(number.error, 'f', number.decimals));
}

} // namespace

double MeasuredNumber::relativeError() const {
    if (value > 0) return error / value;
    return error > 0 ? 1 : 0;
}

LightReading lightReadingOf(const QString& answer) {
    LightReading reading{.illuminance = numberOf(answer, QStringLiteral("illuminance"), QStringLiteral("lx")),
                         .luminance = numberOf(answer, QStringLiteral("luminance"), QStringLiteral("cd/m2")),
                         .unitless = {}};
    const QString last = answer.section(QLatin1Char('\n'), -1);
    if (last.contains(QStringLiteral("no absolute unit"))) reading.unitless = last;
    return reading;
}

QString lightText(const LightReading& reading) {
    QStringList lines;
    if (reading.illuminance) lines << textOf(*reading.illuminance, QStringLiteral("lx"));
    if (reading.luminance) lines << textOf(*reading.luminance, QStringLiteral("cd/m²"));
    if (!lines.isEmpty() && !reading.unitless.isEmpty()) lines << tr("some light has no absolute unit");
    return lines.join(QLatin1Char('\n'));
}

} // namespace gui
