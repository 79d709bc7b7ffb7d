#include "gui/panels/light_fields.h"

#include "gui/models/plain_text.h"
#include "gui/panels/power_field.h"
#include "gui/panels/value_box.h"
#include "gui/view/plain_widgets.h"

#include "common/commands/command_lines.h"

#include "rtcore/io/text/cosine.h"
#include "rtcore/math/blackbody.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/settings/settings_table.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

namespace command = app::command;

constexpr double kFar = 1e9, kMaxDegrees = 180, kTurn = 15;
constexpr int kFrame = 14; ///< pixels around the text of a field
constexpr float kUsualTemperature = 4000;

rtcore::Colour tintOf(const rtcore::LightDescription& light) { return tintedLight(light).intensity; }

QString metres() { return QStringLiteral(" m"); }
QString degrees() { return QStringLiteral("°"); }

std::array<float, 3> numbers(const rtcore::Vec3& v) { return {v.x, v.y, v.z}; }

void set(ValueBox& box, double value) {
    if (static_cast<float>(box.value()) != static_cast<float>(value)) box.setValue(value);
}

QString lightKindEnglish(rtcore::LightKind kind) {
    return QString::fromStdString(rtcore::settingLabel(traitsOf(kind).name));
}

} // namespace

QString lightKindText(rtcore::LightKind kind) {
    return QCoreApplication::translate("LightKinds", lightKindEnglish(kind).toUtf8().constData());
}

QStringList lightKindTexts() {
    QStringList texts;
    for (std::size_t i = 0; i < rtcore::kLightKinds; ++i)
        texts << lightKindEnglish(static_cast<rtcore::LightKind>(i));
    return texts;
}

QString lightText(const ShownLight& light) {
    return light.name.isEmpty() ? LightFields::tr("Light %1").arg(light.id) : light.name;
}

QColor lightColour(const rtcore::LightDescription& light) {
    const rtcore::Colour colour = tintOf(light);
    const float largest = std::max(maxComponent(colour), 1e-30F);
    const auto part = [&](float value) {
        return rtcore::srgbEncode(std::clamp(value / largest, 0.0F, 1.0F));
    };
    return QColor::fromRgbF(part(colour.r), part(colour.g), part(colour.b));
}

LightFields::LightFields(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    addIdentity();
    addPlace();
    addColour();
    addShape();
    addFile();
}

void LightFields::send(const char* step, const std::string& line) {
    if (showing_ || light_.id == 0) return;
    emit edited(QStringLiteral("%1 %2").arg(QLatin1String(step)).arg(light_.id), line);
}

QWidget* LightFields::row(const QString& label, std::initializer_list<QWidget*> fields) {
    auto* widget = new QWidget;
    auto* layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (QWidget* field : fields) layout->addWidget(field, 1);
    form_->addRow(label, widget);
    return widget;
}

QWidget* LightFields::rowBelow(const QString& label, const Vector& fields) {
    auto* widget = new QWidget;
    auto* layout = new QGridLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(new PlainLabel(label), 0, 0, 1, -1);
    for (ValueBox* field : fields) layout->addWidget(field, 1, layout->count() - 1);
    form_->addRow(widget);
    return widget;
}

QPushButton* LightFields::button(const QString& text, const QString& tip, const char* step,
                                 std::string (*line)(int)) {
    auto* made = new QPushButton(text);
    made->setToolTip(plainTip(tip));
    connect(made, &QPushButton::clicked, this, [this, step, line] { send(step, line(light_.id)); });
    return made;
}

void LightFields::addIdentity() {
    name_ = new QLineEdit;
    name_->setAccessibleName(tr("Name of the light"));
    form_->addRow(tr("Name"), name_);
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        if (name_->text() != light_.name)
            send("light name", command::lightName(light_.id, name_->text().toStdString()));
    });
    kind_ = new QComboBox;
    kind_->setAccessibleName(tr("Kind of the light"));
    for (std::size_t i = 0; i < rtcore::kLightKinds; ++i)
        kind_->addItem(lightKindText(static_cast<rtcore::LightKind>(i)));
    form_->addRow(tr("Kind"), kind_);
    connect(kind_, &QComboBox::activated, this, [this](int kind) {
        const std::string_view name = rtcore::kLightTraits.at(static_cast<std::size_t>(kind)).name;
        send("light kind", command::lightKind(light_.id, std::string(name)));
    });
}

LightFields::Vector LightFields::vectorFields(const QString& name, double max) {
    Vector fields;
    constexpr std::array<char16_t, 3> kAxes{u'x', u'y', u'z'};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        fields.at(i) = new ValueBox(-max, max);
        fields.at(i)->setAccessibleName(name + QLatin1Char(' ') + QChar(kAxes.at(i)));
        fields.at(i)->setToolTip(plainTip(fields.at(i)->accessibleName()));
        const int text = fields.at(i)->fontMetrics().horizontalAdvance(QStringLiteral("-12.345 m"));
        fields.at(i)->setMinimumWidth(text + kFrame);
        fields.at(i)->setButtonSymbols(QAbstractSpinBox::NoButtons);
    }
    return fields;
}

// The next component may be changed before the server tells of this one.
void LightFields::onPosition() {
    for (std::size_t i = 0; i < position_.size(); ++i) {
        connect(position_.at(i), &QDoubleSpinBox::valueChanged, this, [this, i](double metres) {
            if (showing_ || !light_.description) return;
            rtcore::Vec3& shown = light_.description->light.position;
            rtcore::FilePoint position = origin_.inFile(shown);
            position.at(i) = inUnits(metres);
            shown[static_cast<int>(i)] = origin_.local(position)[static_cast<int>(i)];
            send("light move", command::lightMove(light_.id, origin_.inFile(shown)));
        });
    }
}

void LightFields::onDirection() {
    for (std::size_t i = 0; i < direction_.size(); ++i) {
        connect(direction_.at(i), &QDoubleSpinBox::valueChanged, this, [this, i](double value) {
            if (showing_ || !light_.description) return;
            rtcore::Vec3& shown = light_.description->light.direction;
            shown[static_cast<int>(i)] = static_cast<float>(value);
            send("light aim", command::lightAim(light_.id, numbers(shown)));
        });
    }
}

void LightFields::showPosition(rtcore::Vec3 position) {
    const rtcore::FilePoint inFile = origin_.inFile(position);
    for (std::size_t i = 0; i < position_.size(); ++i) {
        position_.at(i)->setZero(inMetres(origin_.at.at(i)));
        position_.at(i)->showRounded(inMetres(inFile.at(i)));
    }
}

void LightFields::addPlace() {
    position_ = vectorFields(tr("Position"), kFar);
    for (ValueBox* field : position_) field->setSuffix(metres());
    positionRow_ = rowBelow(tr("Position"), position_);
    onPosition();
    positionButtons_ =
        row({}, {button(tr("Here"), tr("Put the light at the camera"), "light move", command::lightMoveHere),
                 button(tr("At view centre"), tr("Put it before the surface in the middle of the image"),
                        "light move", command::lightMoveSeen)});
    direction_ = vectorFields(tr("Direction"), 1);
    directionRow_ = rowBelow(tr("Direction"), direction_);
    onDirection();
    directionButtons_ =
        row({}, {button(tr("Along view"), tr("Let it shine as the camera looks"), "light aim",
                        command::lightAimAhead),
                 button(tr("Aim at view centre"), tr("Let it shine to what is in the middle of the image"),
                        "light aim", command::lightAimSeen)});
    turnRow_ = row({}, {button(tr("Turn left"), tr("Turn it by 15° about its direction"), "light turn",
                               [](int id) { return command::lightTurn(id, kTurn); }),
                        button(tr("Turn right"), tr("Turn it by 15° about its direction"), "light turn",
                               [](int id) { return command::lightTurn(id, -kTurn); })});
}

void LightFields::addColour() {
    colour_ = new QPushButton;
    colour_->setAccessibleName(tr("Colour of the light"));
    colour_->setToolTip(tr("Choose a colour; the power stays"));
    connect(colour_, &QPushButton::clicked, this, &LightFields::chooseColour);
    form_->addRow(tr("Colour"), colour_);
    hasTemperature_ = new QCheckBox;
    hasTemperature_->setAccessibleName(tr("Colour by temperature"));
    temperature_ = new ValueBox(rtcore::kMinTemperature, rtcore::kMaxTemperature);
    temperature_->setSuffix(QStringLiteral(" K"));
    temperature_->setAccessibleName(tr("Temperature"));
    temperature_->setToolTip(tr("Of a black body: candle 1900 K, bulb 2700 K, sun 5800 K"));
    auto* both = row(tr("Temperature"), {hasTemperature_, temperature_});
    static_cast<QHBoxLayout*>(both->layout())->setStretch(0, 0);
    connect(hasTemperature_, &QCheckBox::clicked, this, [this](bool on) {
        send("light temperature", on ? command::lightTemperature(light_.id, temperature_->value())
                                     : command::lightNoTemperature(light_.id));
    });
    connect(temperature_, &QDoubleSpinBox::valueChanged, this, [this](double kelvin) {
        if (hasTemperature_->isChecked())
            send("light temperature", command::lightTemperature(light_.id, kelvin));
    });
    power_ = new PowerField;
    form_->addRow(tr("Power"), power_);
    connect(power_, &PowerField::edited, this, [this](double value, const std::string& unit) {
        send("light power", command::lightPower(light_.id, value, unit));
    });
}

void LightFields::addFile() {
    file_ = new QPushButton;
    file_->setAccessibleName(tr("File of the light"));
    file_->setToolTip(plainTip(tr("An IES or EULUMDAT file, which says how the luminaire shines")));
    form_->addRow(tr("File"), file_);
    connect(file_, &QPushButton::clicked, this, &LightFields::chooseFile);
}

void LightFields::addShape() {
    for (std::size_t i = 0; i < size_.size(); ++i) {
        size_.at(i) = new ValueBox(0, kFar);
        angles_.at(i) = new ValueBox(0, kMaxDegrees);
        angles_.at(i)->setSuffix(degrees());
    }
    size_[1]->setAccessibleName(tr("Height"));
    angles_[0]->setAccessibleName(tr("Angle of full brightness"));
    angles_[1]->setAccessibleName(tr("Angle where it ends"));
    for (ValueBox* box : {size_[1], angles_[0], angles_[1]}) box->setToolTip(plainTip(box->accessibleName()));
    sizeRow_ = row(tr("Size"), {size_[0], size_[1]});
    anglesRow_ = row(tr("Angles"), {angles_[0], angles_[1]});
    mirrored_ = new QCheckBox(tr("Seen in mirrors"));
    mirrored_->setToolTip(
        tr("Mirrors, lacquer and glass that bends show the light itself; the camera does not"));
    form_->addRow(mirrored_);
    connect(mirrored_, &QCheckBox::clicked, this,
            [this](bool on) { send("light mirrored", command::lightMirrored(light_.id, on)); });
    for (ValueBox* box : size_) {
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            if (!light_.description) return;
            const rtcore::LightTraits& traits = traitsOf(light_.description->light);
            const double size = size_[0]->value();
            send("light size", traits.sides
                                   ? command::lightSize(light_.id, inUnits(size), inUnits(size_[1]->value()))
                                   : command::lightSize(light_.id, traits.disc ? size : inUnits(size)));
        });
    }
    for (ValueBox* box : angles_) {
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            if (angles_[0]->value() < angles_[1]->value())
                send("light angles",
                     command::lightAngles(light_.id, angles_[0]->value(), angles_[1]->value()));
        });
    }
}

// Without the digits of the unit's rounding.
double LightFields::inUnits(double metres) const {
    return QString::number(metres / static_cast<double>(metresPerUnit_), 'g', 7).toDouble();
}

void LightFields::showSize(const rtcore::Light& light) {
    const rtcore::LightTraits& traits = traitsOf(light);
    static_cast<QLabel*>(form_->labelForField(sizeRow_))
        ->setText(traits.disc || traits.sides ? tr("Size") : tr("Radius"));
    size_[0]->setMaximum(traits.disc ? kMaxDegrees : kFar);
    size_[0]->setSuffix(traits.disc ? degrees() : metres());
    size_[1]->setSuffix(metres());
    size_[0]->setAccessibleName(traits.disc    ? tr("Angle under which it is seen")
                                : traits.sides ? tr("Width")
                                               : tr("Radius"));
    size_[0]->setToolTip(
        plainTip(traits.disc ? tr("The sun has 0.53°; 0: shadows are sharp") : size_[0]->accessibleName()));
    if (traits.disc)
        set(*size_[0], rtcore::degreesOfHalfSine(light.discSine));
    else
        size_[0]->showRounded(inMetres(double{traits.sides ? light.width : light.radius}));
    size_[1]->showRounded(inMetres(double{light.height}));
    size_[1]->setVisible(traits.sides);
}

void LightFields::show(const ShownLight& light, float metresPerUnit, const rtcore::LocalOrigin& origin) {
    light_ = light;
    metresPerUnit_ = metresPerUnit;
    origin_ = origin;
    const rtcore::Light& shines = light.description->light;
    const rtcore::LightTraits& traits = traitsOf(shines);
    showing_ = true;
    if (!name_->hasFocus() || !name_->isModified()) name_->setText(light.name);
    kind_->setCurrentIndex(static_cast<int>(shines.kind));
    showPosition(shines.position);
    for (std::size_t i = 0; i < direction_.size(); ++i)
        direction_.at(i)->showRounded(static_cast<double>(numbers(shines.direction).at(i)));
    const float temperature = light.description->temperature;
    hasTemperature_->setChecked(temperature > 0);
    temperature_->setEnabled(temperature > 0);
    set(*temperature_, static_cast<double>(temperature > 0 ? temperature : kUsualTemperature));
    const float power = light.power.value_or(rtcore::powerOf(tintedLight(*light.description)));
    power_->show(shines, static_cast<double>(power), metresPerUnit);
    showSize(shines);
    if (traits.beam == rtcore::Beam::Cone) {
        set(*angles_[0], rtcore::degreesOfCosine(shines.cosInner));
        set(*angles_[1], rtcore::degreesOfCosine(shines.cosOuter));
    }
    mirrored_->setChecked(shines.mirrored != 0);
    const auto& file = light.description->file;
    const bool ofModel = file.empty() && light.description->modelLuminaire > 0;
    file_->setText(ofModel        ? tr("of the model")
                   : file.empty() ? tr("Choose…")
                                  : plainText(QString::fromStdString(file.filename().string())));
    showColour();
    showRows(traits);
    showing_ = false;
}

void LightFields::showRows(const rtcore::LightTraits& traits) {
    form_->setRowVisible(positionRow_, traits.position);
    form_->setRowVisible(positionButtons_, traits.position);
    form_->setRowVisible(directionRow_, traits.direction);
    form_->setRowVisible(directionButtons_, traits.direction);
    form_->setRowVisible(anglesRow_, traits.beam == rtcore::Beam::Cone);
    form_->setRowVisible(mirrored_, traits.radius || traits.sides);
    form_->setRowVisible(turnRow_, traits.turns());
    form_->setRowVisible(file_, traits.beam == rtcore::Beam::Measured);
}

void LightFields::chooseFile() {
    auto* dialog =
        new QFileDialog(this, tr("Open a luminaire"), {}, tr("Luminaires (*.ies *.ldt);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        send("light file", command::lightFile(light_.id, QFileInfo(path).absoluteFilePath().toStdString()));
    });
    dialog->open();
}

// --- Colour ---

void LightFields::showColour() {
    QPixmap swatch(32, 14);
    swatch.fill(lightColour(*light_.description));
    colour_->setIcon(QIcon(swatch));
    colour_->setIconSize(swatch.size());
}

void LightFields::chooseColour() {
    auto* dialog = new QColorDialog(lightColour(*light_.description), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour of the light"));
    connect(dialog, &QColorDialog::currentColorChanged, this, [this](const QColor& colour) {
        const auto part = [](float value) { return rtcore::srgbDecode(value); };
        const std::array<float, 3> linear{part(colour.redF()), part(colour.greenF()), part(colour.blueF())};
        if (linear[0] + linear[1] + linear[2] > 0)
            send("light colour", command::lightColour(light_.id, linear));
    });
    dialog->open();
}

} // namespace gui
