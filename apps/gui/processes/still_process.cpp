#include "gui/processes/still_process.h"

#include "gui/processes/programs.h"

#include <QProcess>
#include <QTemporaryDir>

namespace gui {

StillProcess::StillProcess(Session& session, QObject* parent) : QObject(parent), session_(session) {}
StillProcess::~StillProcess() { cancel(); }

void StillProcess::render(int antialiasing, int bloom) {
    cancel();
    antialiasing_ = antialiasing;
    bloom_ = bloom;
    folder_ = std::make_unique<QTemporaryDir>();
    if (!folder_->isValid()) return fail(folder_->errorString());
    emit activeChanged();
    exportScene();
}

QString StillProcess::file(const QString& name) const { return folder_->filePath(name); }

// Answers that come after cancel() belong to a folder that is gone.
void StillProcess::exportScene() {
    const QSize size = session_.status().resolution;
    const QString folder = folder_->path();
    const auto stillWanted = [this, folder] { return folder_ != nullptr && folder_->path() == folder; };
    session_.send(
        Session::line({QStringLiteral("export"), QStringLiteral("scene"), file(QStringLiteral("view.scn"))}),
        this, [this, stillWanted](const Answer& answer) {
            if (stillWanted() && !answer.done) fail(answer.text);
        });
    session_.send(
        Session::line({QStringLiteral("export"), QStringLiteral("camera"), file(QStringLiteral("view.cam")),
                       QString::number(size.width()), QString::number(size.height()),
                       QString::number(antialiasing_), QString::number(bloom_)}),
        this, [this, stillWanted](const Answer& answer) {
            if (!stillWanted()) return;
            answer.done ? launch() : fail(answer.text);
        });
}

void StillProcess::launch() {
    const QString program = programPath(QStringLiteral("Renderer"));
    if (program.isEmpty())
        return fail(tr("The program Renderer was found neither beside this one nor in PATH."));
    process_ = new QProcess(this);
    connect(process_, &QProcess::finished, this, [this](int exitCode, QProcess::ExitStatus status) {
        take(exitCode, status == QProcess::CrashExit);
    });
    connect(process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) fail(process_->errorString());
    });
    process_->start(program, {file(QStringLiteral("view.scn")),
                              QStringLiteral("--camera=") + file(QStringLiteral("view.cam")),
                              QStringLiteral("--output=") + file(QStringLiteral("view.png")),
                              QStringLiteral("--progress=none")});
}

void StillProcess::take(int exitCode, bool crashed) {
    if (crashed || exitCode != 0) {
        const QString words = QString::fromUtf8(process_->readAllStandardError()).trimmed();
        return fail(words.isEmpty() ? tr("The Renderer failed.") : words);
    }
    const QImage picture(file(QStringLiteral("view.png")));
    if (picture.isNull()) return fail(tr("The Renderer's picture cannot be read."));
    cancel();
    emit rendered(picture);
}

void StillProcess::fail(const QString& text) {
    cancel();
    emit failed(text);
}

void StillProcess::cancel() {
    if (process_ != nullptr) {
        process_->disconnect(this);
        process_->kill();
        // It is reaped by its event; the destructor would wait for it.
        connect(process_, &QProcess::finished, process_, &QObject::deleteLater);
        if (process_->state() == QProcess::NotRunning) process_->deleteLater();
        process_ = nullptr;
    }
    if (folder_ == nullptr) return;
    folder_.reset();
    emit activeChanged();
}

} // namespace gui
