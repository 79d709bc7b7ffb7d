#include "gui/panels/value_box.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

constexpr int kAllDecimals = 60; ///< QDoubleSpinBox rounds to them
constexpr double kFirstStep = 0.01;
constexpr double kMinPlain = 1e-5, kMaxPlain = 1e7; ///< shown without an exponent

} // namespace

ValueBox::ValueBox(double minimum, double maximum, QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(kAllDecimals);
    setRange(minimum, maximum);
}

QString ValueBox::textFromValue(double value) const {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double size = std::abs(value);
    // "1E+05" is shorter than "100000", but harder to read.
    const bool plain = size == 0 || (size >= kMinPlain && size < kMaxPlain);
    return locale.toString(value, plain ? 'f' : 'g', QLocale::FloatingPointShortest);
}

QString ValueBox::bare(const QString& text) const {
    QString number = text;
    if (!suffix().isEmpty() && number.endsWith(suffix())) number.chop(suffix().size());
    return number.trimmed();
}

bool ValueBox::saysMinimum(const QString& text) const {
    return !specialValueText().isEmpty() && bare(text).compare(specialValueText(), Qt::CaseInsensitive) == 0;
}

double ValueBox::valueFromText(const QString& text) const {
    if (saysMinimum(text)) return minimum();
    bool good = false;
    double value = QLocale().toDouble(bare(text), &good);
    if (!good) value = QLocale::c().toDouble(bare(text));
    return whole_ ? std::round(value) : value;
}

// "1e" may become a number; letters of other kinds may not.
QValidator::State ValueBox::validate(QString& text, int&) const {
    if (saysMinimum(text)) return QValidator::Acceptable;
    const QString number = bare(text);
    if (!number.isEmpty() && specialValueText().startsWith(number, Qt::CaseInsensitive))
        return QValidator::Intermediate;
    bool good = false;
    double value = QLocale().toDouble(number, &good);
    if (!good) value = QLocale::c().toDouble(number, &good);
    if (good)
        return value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
    const bool possible = std::all_of(number.begin(), number.end(), [](QChar letter) {
        return letter.isDigit() || QStringLiteral("+-.,eE").contains(letter);
    });
    return possible ? QValidator::Intermediate : QValidator::Invalid;
}

void ValueBox::stepBy(int steps) {
    const double size = std::abs(value() - zero_);
    double step = size > 0 ? std::pow(10.0, std::floor(std::log10(size)) - 1) : kFirstStep;
    if (whole_) step = 1;
    // To a multiple of the step: no spurious digits.
    const double wanted = (std::round((value() - zero_) / step) + steps) * step;
    setValue(zero_ + QLocale::c().toDouble(QLocale::c().toString(wanted, 'g', 6)));
    selectAll();
}

void ValueBox::showRounded(double value) {
    const double rounded = QString::number(value - zero_, 'g', 5).toDouble();
    if (static_cast<float>(this->value() - zero_) != static_cast<float>(rounded)) setValue(zero_ + rounded);
}

QSize ValueBox::sizeHint() const {
    QSize size = QAbstractSpinBox::sizeHint();
    size.setWidth(minimumSizeHint().width());
    return size;
}

} // namespace gui
