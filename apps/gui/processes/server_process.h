/// An RTServer that this program starts. It may outlive the program.
#pragma once

#include <QObject>
#include <QSize>
#include <QString>
#include <QStringList>

class QProcess;

namespace gui {

struct ServerRequest {
    QString scene; ///< .scn, .bsp or a model
    QString instance = QStringLiteral("default");
    QSize resolution;    ///< empty: the scene's own
    QStringList options; ///< further ones, as RTServer takes them
    bool keep = false;   ///< it goes on when this program ends, however that happens
};

/// The option that lets a server draw fewer pixels in motion where a frame would take longer.
QStringList frameTimeOption(int milliseconds);

/// One server at a time. Its messages go to a file, so that they can be read after its death, and so that it
/// can go on without us.
class ServerProcess : public QObject {
    Q_OBJECT

  public:
    explicit ServerProcess(QObject* parent = nullptr);
    /// Ends a server that still runs, gently, then not; unless it was released.
    ~ServerProcess() override;

    /// None may be running.
    void start(const ServerRequest& request);
    bool running() const;
    qint64 process() const; ///< 0 when none runs
    const ServerRequest& request() const { return request_; }
    QString log() const; ///< the last 256 kB of what it printed
    /// The last line, without "RTServer: ": why it ended, when it ended with a failure.
    QString lastWords() const;

    /// Asks it to end, and kills it when it has not done so within `patience`. ended() follows.
    void stop(int patienceMilliseconds = 3000);
    /// From now on it is detached: it keeps running when this program ends.
    void release();

  signals:
    /// It could not be started, or it is gone. `text` explains, and is empty after an end that was asked for.
    void ended(const QString& text);

  private:
    void tellEnd(int exitCode, bool crashed);

    QProcess* process_ = nullptr;
    ServerRequest request_;
    QString logFile_;
    bool stopping_ = false;
};

} // namespace gui
