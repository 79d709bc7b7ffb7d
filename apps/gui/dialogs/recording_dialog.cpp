#include "gui/dialogs/recording_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/file_field.h"
#include "gui/models/preferences.h"
#include "gui/view/plain_widgets.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>

namespace gui {

RecordingDialog::RecordingDialog(Session& session, const QString& folder, QWidget* parent)
    : QDialog(parent), session_(session), path_(new FileField(FileField::Kind::Save, tr("List of cameras"),
                                                              tr("Lists (*.lst *.txt);;All files (*)"))),
      button_(new QPushButton), play_(new QPushButton(tr("P&lay"))),
      film_(new QPushButton(tr("Render as &film…"))), state_(wrappedLabel()) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Recording"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(button_, QDialogButtonBox::ActionRole);
    buttons->addButton(play_, QDialogButtonBox::ActionRole);
    buttons->addButton(film_, QDialogButtonBox::ActionRole);
    connect(play_, &QPushButton::clicked, this, &RecordingDialog::play);
    connect(film_, &QPushButton::clicked, this, [this] { emit filmWanted(path_->path()); });
    auto* hint = wrappedLabel(tr("From Start to Stop the camera, the exposure and the lights are written 30 "
                                 "times a second: .cam files "
                                 "and their list, which the Renderer makes a film of."));
    auto* form = new QFormLayout(this);
    form->addRow(hint);
    form->addRow(tr("&Path:"), path_);
    form->addRow(state_);
    form->addRow(buttons);
    button_->setDefault(true); // once it belongs to the dialog
    connect(button_, &QPushButton::clicked, this, &RecordingDialog::toggle);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(path_, &FileField::pathChanged, this, &RecordingDialog::refresh);
    connect(&session_, &Session::statusChanged, this, &RecordingDialog::onStatus);
    connect(&session_, &Session::stateChanged, this, &RecordingDialog::onStatus);
    connect(&timer_, &QTimer::timeout, this, &RecordingDialog::refresh);
    constexpr int kTenth = 100; // milliseconds
    timer_.setInterval(kTenth);
    path_->setPath(nextFreeName(folder, QStringLiteral("walk"), QStringLiteral("lst")));
    onStatus();
    refresh();
}

void RecordingDialog::toggle() {
    if (recording_) {
        session_.send(command::exportVideoStop(), this, [this](const Answer& answer) { tell(answer); });
        return;
    }
    // An existing recording is never overwritten.
    if (QFileInfo::exists(path_->path())) path_->setPath(freeList(path_->path()));
    session_.send(command::exportVideoStart(path_->path().toStdString()), this,
                  [this](const Answer& answer) { tell(answer); });
}

// walk-0002.lst for walk-0001.lst.
QString RecordingDialog::freeList(const QString& like) const {
    static const QRegularExpression number(QStringLiteral("-\\d+$"));
    const QFileInfo file(like);
    return nextFreeName(file.absolutePath(), file.completeBaseName().remove(number), file.suffix());
}

void RecordingDialog::play() {
    session_.send(command::play(path_->path().toStdString()), this,
                  [this](const Answer& answer) { tell(answer); });
}

void RecordingDialog::tell(const Answer& answer) {
    if (!answer.done) state_->setText(answer.text);
}

void RecordingDialog::onStatus() {
    const bool live = session_.live(), recording = session_.status().recording;
    if (live == live_ && recording == recording_) return;
    live_ = live;
    recording_ = live && recording;
    if (live) ask();
    refresh();
}

void RecordingDialog::ask() {
    session_.send(command::exportVideo(), this, [this](const Answer& answer) {
        if (answer.done) take(answer.text);
    });
}

// "on SECONDS LIST", "off LIST" or "off".
void RecordingDialog::take(const QString& text) {
    const bool on = text.startsWith(QStringLiteral("on "));
    const QString list = text.section(QLatin1Char(' '), on ? 2 : 1);
    if (on || QFileInfo(list).isFile()) path_->setPath(list);
    before_ = on ? text.section(QLatin1Char(' '), 1, 1).toDouble() : 0;
    clock_.start();
    on ? timer_.start() : timer_.stop();
    if (!on) state_->setText(list.isEmpty() ? QString() : tr("Recorded: %1").arg(list));
    refresh();
}

void RecordingDialog::refresh() {
    const bool there = QFileInfo(path_->path()).isFile();
    button_->setEnabled(live_);
    button_->setText(recording_ ? tr("&Stop") : tr("&Start"));
    path_->setEnabled(!recording_);
    play_->setEnabled(live_ && !recording_ && there);
    film_->setEnabled(!recording_ && there);
    if (!recording_ || !timer_.isActive()) return;
    constexpr double kMilliseconds = 1000;
    const double seconds = before_ + static_cast<double>(clock_.elapsed()) / kMilliseconds;
    state_->setText(tr("Recording %1 for %2 s.")
                        .arg(QFileInfo(path_->path()).fileName(), QLocale().toString(seconds, 'f', 1)));
}

} // namespace gui
