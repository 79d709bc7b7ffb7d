#include "gui/processes/bridge_process.h"

#include "gui/processes/detach.h"
#include "gui/processes/programs.h"
#include "gui/session/printed_lines.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTimer>

#include <utility>

namespace gui {

namespace {

constexpr int kBridgePatience = 3000; ///< milliseconds, with a bridge that does not end when it is asked to

/// "Driver: LINK" gives LINK to the driver.
void takeLink(const QByteArray& line, BridgeLinks& links) {
    const QString text = QString::fromUtf8(line).trimmed();
    for (const auto& [title, link] : {std::pair(QStringLiteral("Driver: "), &links.driver),
                                      {QStringLiteral("Viewer: "), &links.viewer},
                                      {QStringLiteral("Certificate: "), &links.certificate}})
        if (text.startsWith(title)) *link = text.mid(title.size());
}

} // namespace

QStringList bridgeWords(const BridgeRequest& request) {
    QStringList words{QStringLiteral("--instance=") + request.instance,
                      QStringLiteral("--parent=%1").arg(QCoreApplication::applicationPid())};
    if (!request.address.isEmpty()) {
        const bool colons = request.address.contains(QLatin1Char(':'));
        words.append(QStringLiteral("--listen=") +
                     (colons ? QStringLiteral("[%1]") : QStringLiteral("%1")).arg(request.address));
        if (!request.encrypted()) words.append(QStringLiteral("--insecure"));
    }
    if (request.ownCertificate) words.append(QStringLiteral("--tls-own"));
    if (!request.certificate.isEmpty())
        words << QStringLiteral("--tls-cert=") + request.certificate
              << QStringLiteral("--tls-key=") + request.key;
    if (!request.mayDrive) words.append(QStringLiteral("--view-only"));
    if (!request.mayEdit) words.append(QStringLiteral("--lock=edits"));
    if (request.mayNote) words.append(QStringLiteral("--visitor-notes"));
    return words;
}

BridgeProcess::BridgeProcess(const QString& program, QObject* parent) : QObject(parent), program_(program) {}

BridgeProcess::~BridgeProcess() {
    if (!running()) return;
    process_->disconnect(this);
    process_->terminate();
    if (process_->waitForFinished(kBridgePatience)) return;
    process_->kill();
    process_->waitForFinished(kBridgePatience);
}

qint64 BridgeProcess::process() const { return running() ? process_->processId() : 0; }

void BridgeProcess::start(const BridgeRequest& request) {
    request_ = request;
    links_ = {};
    rest_.clear();
    stopping_ = false;
    process_ = new QProcess(this);
    process_->setStandardInputFile(QProcess::nullDevice());
    startDetached(*process_);
    connect(process_, &QProcess::readyReadStandardOutput, this, &BridgeProcess::readLinks);
    connect(process_, &QProcess::finished, this, [this](int exitCode, QProcess::ExitStatus status) {
        finish(lastWords(exitCode, status == QProcess::CrashExit));
    });
    connect(
        process_, &QProcess::errorOccurred, this,
        [this](QProcess::ProcessError error) {
            if (error == QProcess::FailedToStart)
                finish(tr("RTBridge cannot be started: %1").arg(process_->errorString()));
        },
        Qt::QueuedConnection); // never from within start()
    const QString program = programPath(program_);
    if (!program.isEmpty()) return process_->start(program, bridgeWords(request));
    QTimer::singleShot(0, process_, [this] {
        finish(tr("The program RTBridge was found neither beside this one nor in PATH. It is part of the "
                  "package, and of a build that finds libturbojpeg and libdeflate."));
    });
}

void BridgeProcess::stop() {
    if (!running() || std::exchange(stopping_, true)) return;
    if (process_->state() == QProcess::NotRunning) return; // its end is on the way
    process_->terminate();
    QTimer::singleShot(kBridgePatience, process_, [process = process_] { process->kill(); });
}

void BridgeProcess::readLinks() {
    rest_ += process_->readAllStandardOutput();
    const BridgeLinks before = links_;
    for (qsizetype end = 0; (end = rest_.indexOf('\n')) >= 0; rest_.remove(0, end + 1))
        takeLink(rest_.left(end), links_);
    // The viewer's comes last.
    if (!links_.viewer.isEmpty() && links_ != before) emit linksChanged();
}

QString BridgeProcess::lastWords(int exitCode, bool crashed) {
    if (crashed) return tr("RTBridge was killed or has crashed (signal %1).").arg(exitCode);
    const QString prefix = QStringLiteral("RTBridge: ");
    const QString line = translatedOutput(QString::fromUtf8(process_->readAllStandardError()))
                             .trimmed()
                             .section(QLatin1Char('\n'), -1);
    if (line.isEmpty()) return tr("RTBridge ended with exit code %1.").arg(exitCode);
    return line.startsWith(prefix) ? line.mid(prefix.size()) : line;
}

void BridgeProcess::finish(const QString& text) {
    if (!running()) return;
    std::exchange(process_, nullptr)->deleteLater();
    links_ = {};
    emit ended(std::exchange(stopping_, false) ? QString() : text);
}

} // namespace gui
