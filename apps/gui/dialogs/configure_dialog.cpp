#include "gui/dialogs/configure_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/file_field.h"
#include "gui/dialogs/key_bindings_page.h"
#include "gui/models/at_rest.h"
#include "gui/models/mouse_scheme.h"
#include "gui/models/still_quality.h"
#include "gui/session/session.h"
#include "gui/view/plain_widgets.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace gui {

namespace {

QString asText(const QList<Binding>& bindings) {
    QStringList lines;
    for (const Binding& each : bindings) {
        const QString number = each.number > 0 ? QStringLiteral(" %1").arg(each.number) : QString();
        lines.append(each.keys + QLatin1Char(' ') + each.action + number);
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace

ConfigureDialog::ConfigureDialog(Preferences& preferences, Session& session, QWidget* parent)
    : QDialog(parent), preferences_(preferences), session_(session), keys_(new KeyBindingsPage) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Preferences"));
    auto* tabs = new QTabWidget;
    tabs->addTab(generalPage(), tr("&General"));
    tabs->addTab(picturePage(), tr("&Image"));
    tabs->addTab(inputPage(), tr("&Mouse"));
    tabs->addTab(keys_, tr("K&eys"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    auto* column = new QVBoxLayout(this);
    column->addWidget(tabs);
    column->addWidget(buttons);
    constexpr QSize kSize(520, 480);
    resize(kSize);
    connect(keys_, &KeyBindingsPage::changed, this, [this] { ok_->setEnabled(keys_->valid()); });
    connect(buttons, &QDialogButtonBox::accepted, this, &ConfigureDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    askForBindings();
}

QWidget* ConfigureDialog::generalPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    addTheme(*form);
    addLanguage(*form);
    addShortcuts(*form);
    auto* folder = new FileField(FileField::Kind::Folder, tr("Image folder"), QString());
    folder->setPath(preferences_.picturesFolder());
    form->addRow(tr("Image &folder:"), folder);
    stores_.append([this, folder] { preferences_.set(pref::pictureFolder, folder->path()); });
    constexpr int kMaxMegabytes = 1000000;
    addNumber(*form, tr("Mo&del cache:"), pref::modelCacheMegabytes, 0, kMaxMegabytes, tr(" MB"), tr("none"));
    addSwitch(*form, tr("&Keep servers running when the window closes"), pref::keepServers);
    addAtRest(*form);
    return page;
}

QWidget* ConfigureDialog::picturePage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    addSwitch(*form, tr("Viewport fo&llows the window's size"), pref::followWindowSize);
    addScale(*form);
    constexpr int kMaxMilliseconds = 1000;
    addNumber(*form, tr("Frame &time in motion:"), pref::frameTime, 0, kMaxMilliseconds, tr(" ms"),
              tr("none"));
    addStillQuality(*form);
    constexpr int kMaxSamples = 16, kMaxBloom = 4096;
    addNumber(*form, tr("&H exports anti-aliasing:"), pref::highQualityAntialiasing, 1, kMaxSamples, {}, {});
    addNumber(*form, tr("H exports bl&oom:"), pref::highQualityBloom, 0, kMaxBloom, tr(" pixels"),
              tr("none"));
    return page;
}

QWidget* ConfigureDialog::inputPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    addSensitivity(*form);
    addSwitch(*form, tr("In&vert up and down"), pref::invertMouse);
    addMouseScheme(*form);
    return page;
}

void ConfigureDialog::addSwitch(QFormLayout& form, const QString& text, const Preference<bool>& row) {
    auto* box = new QCheckBox(text);
    box->setChecked(preferences_.get(row));
    form.addRow(QString(), box);
    stores_.append([this, box, &row] { preferences_.set(row, box->isChecked()); });
}

void ConfigureDialog::addNumber(QFormLayout& form, const QString& text, const Preference<int>& row,
                                int minimum, int maximum, const QString& suffix, const QString& minText) {
    auto* box = new QSpinBox;
    box->setRange(minimum, maximum);
    box->setSpecialValueText(minText);
    box->setValue(preferences_.get(row));
    box->setSuffix(suffix);
    form.addRow(text, box);
    stores_.append([this, box, &row] { preferences_.set(row, box->value()); });
}

void ConfigureDialog::addTheme(QFormLayout& form) {
    auto* box = new QComboBox;
    box->addItem(tr("as the system"), QStringLiteral("system"));
    box->addItem(tr("light"), QStringLiteral("light"));
    box->addItem(tr("dark"), QStringLiteral("dark"));
    box->setCurrentIndex(qMax(0, box->findData(preferences_.get(pref::theme))));
    form.addRow(tr("&Colours:"), box);
    stores_.append([this, box] { preferences_.set(pref::theme, box->currentData().toString()); });
}

void ConfigureDialog::addLanguage(QFormLayout& form) {
    auto* box = new QComboBox;
    box->addItem(tr("as the system"), QStringLiteral("system"));
    box->addItem(QStringLiteral("English"), QStringLiteral("en"));
    box->addItem(QStringLiteral("Čeština"), QStringLiteral("cs"));
    box->setCurrentIndex(qMax(0, box->findData(preferences_.get(pref::language))));
    form.addRow(tr("&Language:"), box);
    form.addRow(QString(), wrappedLabel(tr("The language holds from the next start of the window.")));
    stores_.append([this, box] { preferences_.set(pref::language, box->currentData().toString()); });
}

void ConfigureDialog::addShortcuts(QFormLayout& form) {
    auto* box = new QComboBox;
    box->addItem(tr("usual on desktops"), QStringLiteral("desktop"));
    box->addItem(tr("Classic shortcuts"), QStringLiteral("thesis"));
    box->setCurrentIndex(qMax(0, box->findData(preferences_.get(pref::shortcuts))));
    box->setToolTip(
        tr("Of the menus: Ctrl+S saves and Ctrl+C copies the camera, or they start a server and connect "
           "to one"));
    form.addRow(tr("&Shortcuts:"), box);
    stores_.append([this, box] { preferences_.set(pref::shortcuts, box->currentData().toString()); });
}

void ConfigureDialog::addMouseScheme(QFormLayout& form) {
    auto* box = new QComboBox;
    for (const MouseSchemeText& each : mouseSchemeTexts()) box->addItem(each.text, nameOf(each.scheme));
    box->setCurrentIndex(qMax(0, box->findData(preferences_.get(pref::mouse))));
    box->setToolTip(tr("While a drag turns the model (View > Orbit)"));
    form.addRow(tr("&Drags:"), box);
    stores_.append([this, box] { preferences_.set(pref::mouse, box->currentData().toString()); });
}

void ConfigureDialog::addAtRest(QFormLayout& form) {
    auto* box = new QComboBox;
    fillAtRest(*box);
    box->setCurrentIndex(static_cast<int>(atRest(preferences_)));
    form.addRow(tr("Image at &rest:"), box);
    stores_.append([this, box] { setAtRest(preferences_, static_cast<AtRest>(box->currentIndex())); });
}

void ConfigureDialog::addScale(QFormLayout& form) {
    auto* box = new QComboBox;
    for (const int percent : {100, 75, 50, 33, 25})
        box->addItem(tr("%1 % of the window").arg(percent), percent);
    box->setCurrentIndex(qMax(0, box->findData(preferences_.get(pref::pictureScale))));
    box->setToolTip(tr("Smaller images are drawn faster"));
    form.addRow(tr("&Size of the viewport:"), box);
    stores_.append([this, box] { preferences_.set(pref::pictureScale, box->currentData().toInt()); });
}

// Settings of progressive rendering and quick render, which do better than the live frame.
void ConfigureDialog::addStillQuality(QFormLayout& form) {
    constexpr int kMaxSamples = 16, kMaxBloom = 4096, kMaxRays = 4096;
    const QString asLive = tr("same as viewport");
    constexpr int kMaxPaths = 65536, kMaxFilterPasses = 8;
    addNumber(form, tr("Global illumination, sam&ples:"), pref::stillPathSamples, 0, kMaxPaths, {}, asLive);
    addDenoise(form);
    addNumber(form, tr("Passes of the &filter:"), pref::stillFilter, 1, kMaxFilterPasses, {}, {});
    addNumber(form, tr("&Quick render, anti-aliasing:"), pref::stillAntialiasing, 1, kMaxSamples, {}, {});
    auto* occlusion = new QComboBox;
    occlusion->addItem(asLive, QStringLiteral("live"));
    occlusion->addItem(tr("on"), QStringLiteral("on"));
    occlusion->addItem(tr("off"), QStringLiteral("off"));
    occlusion->setCurrentIndex(qMax(0, occlusion->findData(preferences_.get(pref::stillOcclusion))));
    form.addRow(tr("Quick render, &ambient occlusion:"), occlusion);
    stores_.append(
        [this, occlusion] { preferences_.set(pref::stillOcclusion, occlusion->currentData().toString()); });
    addNumber(form, tr("Quick render, occlusion &rays:"), pref::stillOcclusionSamples, 0, kMaxRays, {},
              asLive);
    addNumber(form, tr("Quick render, &bloom:"), pref::stillBloom, -1, kMaxBloom, tr(" pixels"), asLive);
}

void ConfigureDialog::addDenoise(QFormLayout& form) {
    auto* box = new QComboBox;
    box->addItem(tr("by a net; by the filter where its weights are missing"), nameOf(StillDenoise::Net));
    box->addItem(tr("by the filter"), nameOf(StillDenoise::Filter));
    box->addItem(tr("off"), nameOf(StillDenoise::Off));
    box->setCurrentIndex(qMax(0, box->findData(nameOf(stillDenoise(preferences_)))));
    form.addRow(tr("Global illumination, &denoise:"), box);
    stores_.append([this, box] { preferences_.set(pref::stillDenoise, box->currentData().toString()); });
}

void ConfigureDialog::addSensitivity(QFormLayout& form) {
    auto* box = new QDoubleSpinBox;
    constexpr double kMin = 0.01, kMax = 2, kStep = 0.02;
    box->setRange(kMin, kMax);
    box->setSingleStep(kStep);
    box->setValue(preferences_.get(pref::mouseSensitivity));
    box->setSuffix(tr("° per pixel"));
    form.addRow(tr("&Sensitivity:"), box);
    stores_.append([this, box] { preferences_.set(pref::mouseSensitivity, box->value()); });
}

void ConfigureDialog::askForBindings() {
    const QList<Binding> chosen = readBindings(preferences_.get(pref::bindings));
    present_ = chosen.isEmpty() ? defaultBindings() : chosen;
    keys_->setBindings(present_);
    if (!session_.live()) return;
    session_.send(command::bindings(), this, [this](const Answer& answer) {
        const QList<Binding> bindings = answer.done ? readBindings(answer.text) : QList<Binding>();
        if (bindings.isEmpty()) return;
        present_ = bindings;
        keys_->setBindings(bindings);
    });
}

void ConfigureDialog::applyBindings() {
    const QList<Binding> wanted = keys_->bindings();
    if (wanted == present_) return;
    preferences_.set(pref::bindings, wanted == defaultBindings() ? QString() : asText(wanted));
    if (!session_.live()) return;
    for (const std::string& line : bindingChanges(present_, wanted)) session_.send(line);
}

void ConfigureDialog::finish() {
    for (const std::function<void()>& store : stores_) store();
    applyBindings();
    accept();
}

} // namespace gui
