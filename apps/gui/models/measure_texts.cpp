#include "gui/models/measure_texts.h"

#include "gui/models/plain_text.h"
#include "gui/models/translated.h"

#include <QLocale>

#include <array>

namespace gui {

QString measureText(const rtcore::MeasureValue& value, rtcore::LengthUnit unit) {
    const std::array<QString, 4> powers{QString(), QString(), QStringLiteral("²"), QStringLiteral("³")};
    const QString number = QLocale().toString(value.value, 'f', value.decimals);
    if (value.power == 0) return number + QStringLiteral("°");
    const std::string_view name = nameOf(unit);
    return number + QLatin1Char(' ') + QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())) +
           powers.at(static_cast<std::size_t>(value.power));
}

QString measureKindText(rtcore::MeasureKind kind) {
    const std::array<QString, rtcore::kMeasureKinds.size()> texts{tr("Distance"), tr("Chain"), tr("Angle"),
                                                                  tr("Height"),   tr("Area"),  tr("Volume")};
    return texts.at(static_cast<std::size_t>(kind));
}

double metresPerUnitOf(const SceneState& state) {
    return QString::number(static_cast<double>(state.metresPerUnit), 'g', 7).toDouble();
}

QString measureRow(const SceneState& state, int index) {
    const rtcore::KeptMeasure& measure = state.measures.all[static_cast<std::size_t>(index)];
    const rtcore::MeasureValue value = valueOf(measure, state.measures, metresPerUnitOf(state));
    QString text = QStringLiteral("%1  %2 %3")
                       .arg(QString::number(index + 1), measureKindText(measure.kind),
                            measureText(value, state.measures.unit));
    if (!measure.name.empty()) text += QStringLiteral("  ") + plainText(QString::fromStdString(measure.name));
    return text;
}

QList<MeasureLabel> labelsOf(const rtcore::KeptMeasure& measure, const SceneState& state) {
    const double metres = metresPerUnitOf(state);
    const rtcore::LengthUnit unit = state.measures.unit;
    const bool sum = measure.kind == rtcore::MeasureKind::Chain;
    QString text = measureText(valueOf(measure, state.measures, metres), unit);
    if (sum) text = QStringLiteral("Σ ") + text;
    if (!measure.name.empty())
        text = plainText(QString::fromStdString(measure.name)) + QLatin1Char(' ') + text;
    QList<MeasureLabel> labels{{labelPoint(measure), text, sum}};
    const std::vector<rtcore::MeasureValue> legs = legsOf(measure, state.measures, metres);
    for (std::size_t i = 0; i < legs.size(); ++i)
        labels.append({(measure.points[i] + measure.points[i + 1]) * 0.5, measureText(legs[i], unit)});
    return labels;
}

} // namespace gui
