/// The RTBridge that shows a server in web pages.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

class QProcess;

namespace gui {

struct BridgeRequest {
    QString instance;            ///< of the server
    QString address;             ///< a numeric one of this machine; empty: pages of this machine alone
    bool ownCertificate = false; ///< TLS by one that the bridge makes and keeps
    QString certificate, key;    ///< TLS by these files in PEM; both empty, and none of its own: without
    bool encrypted() const { return ownCertificate || !certificate.isEmpty(); }
    bool mayDrive = true; ///< pages with the driver's link
    bool mayEdit = true;  ///< those that drive: settings, lights, materials
    bool mayNote = false; ///< all of them, those that only look, too: notes with their name
};

/// As RTBridge takes them.
QStringList bridgeWords(const BridgeRequest& request);

struct BridgeLinks {
    QString driver, viewer; ///< the driver's is empty where pages cannot drive
    QString certificate;    ///< of its own, as browsers show it: what it is known by
    friend bool operator==(const BridgeLinks&, const BridgeLinks&) = default;
};

/// One bridge at a time. It ends with this object, and with this program however that ends. Nothing waits but
/// the destructor.
class BridgeProcess : public QObject {
    Q_OBJECT

  public:
    /// `program`: another one in its place.
    explicit BridgeProcess(const QString& program = QStringLiteral("RTBridge"), QObject* parent = nullptr);
    ~BridgeProcess() override;

    /// None may be running.
    void start(const BridgeRequest& request);
    /// Asks it to end; ended() follows.
    void stop();
    bool running() const { return process_ != nullptr; }
    qint64 process() const; ///< 0 when none runs
    const BridgeRequest& request() const { return request_; }
    const BridgeLinks& links() const { return links_; } ///< both empty until linksChanged()

  signals:
    void linksChanged(); ///< first when pages can be opened; then when the driver's link was used
    /// It could not be started, or is gone. `text`: its own words why; empty after stop().
    void ended(const QString& text);

  private:
    void readLinks();
    void finish(const QString& text);
    QString lastWords(int exitCode, bool crashed);

    QString program_;
    QProcess* process_ = nullptr; ///< null: none runs
    BridgeRequest request_;
    BridgeLinks links_;
    QByteArray rest_; ///< of a line
    bool stopping_ = false;
};

} // namespace gui
