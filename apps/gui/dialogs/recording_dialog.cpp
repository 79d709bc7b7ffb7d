#include "gui/dialogs/recording_dialog.h"

#include "gui/dialogs/file_field.h"
#include "gui/models/preferences.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace gui {

RecordingDialog::RecordingDialog(Session& session, const QString& folder, QWidget* parent)
    : QDialog(parent), session_(session), folder_(folder),
      path_(new FileField(FileField::Kind::Save, tr("List of cameras"),
                          tr("Lists (*.lst *.txt);;All files (*)"))),
      button_(new QPushButton), play_(new QPushButton(tr("P&lay"))),
      film_(new QPushButton(tr("Render as &film…"))), state_(new QLabel) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Recording"));
    state_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(button_, QDialogButtonBox::ActionRole);
    buttons->addButton(play_, QDialogButtonBox::ActionRole);
    buttons->addButton(film_, QDialogButtonBox::ActionRole);
    connect(play_, &QPushButton::clicked, this, &RecordingDialog::play);
    connect(film_, &QPushButton::clicked, this, [this] { emit filmWanted(recorded_); });
    auto* hint = new QLabel(tr("From Start to Stop the camera, the exposure and the lights are written 30 "
                               "times a second: .cam files "
                               "and their list, which the Renderer makes a film of."));
    hint->setWordWrap(true);
    auto* form = new QFormLayout(this);
    form->addRow(hint);
    form->addRow(tr("&Path:"), path_);
    form->addRow(state_);
    form->addRow(buttons);
    button_->setDefault(true); // once it belongs to the dialog
    connect(button_, &QPushButton::clicked, this, &RecordingDialog::toggle);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(&session_, &Session::statusChanged, this, &RecordingDialog::refresh);
    connect(&session_, &Session::stateChanged, this, &RecordingDialog::refresh);
    propose();
    refresh();
}

void RecordingDialog::propose() {
    path_->setPath(nextFreeName(folder_, QStringLiteral("walk"), QStringLiteral("lst")));
}

void RecordingDialog::toggle() {
    const bool stop = session_.status().recording;
    QStringList words{QStringLiteral("export"), QStringLiteral("video"),
                      stop ? QStringLiteral("stop") : QStringLiteral("start")};
    if (!stop) words.append(started_ = path_->path());
    session_.send(Session::line(words), this, [this](const Answer& answer) { tell(answer); });
}

void RecordingDialog::play() {
    session_.send(Session::line({QStringLiteral("play"), recorded_}), this,
                  [this](const Answer& answer) { tell(answer); });
}

void RecordingDialog::tell(const Answer& answer) {
    if (!answer.done || !answer.text.isEmpty()) state_->setText(answer.text);
}

void RecordingDialog::refresh() {
    const bool recording = session_.status().recording;
    button_->setEnabled(session_.live());
    path_->setEnabled(!recording);
    button_->setText(recording ? tr("&Stop") : tr("&Start"));
    if (recording && !std::exchange(recording_, true)) clock_.start();
    if (recording) {
        constexpr double kMilliseconds = 1000;
        state_->setText(
            tr("Recording for %1 s.").arg(static_cast<double>(clock_.elapsed()) / kMilliseconds, 0, 'f', 1));
    } else if (std::exchange(recording_, false)) {
        recorded_ = std::exchange(started_, {}); // empty: another program's recording
        state_->setText(tr("Recorded: %1").arg(recorded_.isEmpty() ? path_->path() : recorded_));
        propose();
    }
    play_->setEnabled(session_.live() && !recording && !recorded_.isEmpty());
    film_->setEnabled(!recording && !recorded_.isEmpty());
}

} // namespace gui
