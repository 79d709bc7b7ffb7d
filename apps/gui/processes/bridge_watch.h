/// Who looks at a bridge, by its own account.
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <QTimer>
#include <QUrl>

#include <memory>

class QByteArray;
class QNetworkAccessManager;
class QNetworkReply;

namespace gui {

struct Visitor {
    QString name; ///< as they call themselves; may be empty
    bool drives = false;
    friend bool operator==(const Visitor&, const Visitor&) = default;
};

/// The visitors of all servers in the bridge's /status; none when the text is no status.
QList<Visitor> readVisitors(const QByteArray& status);

/// Asks every two seconds, without waiting.
class BridgeWatch : public QObject {
    Q_OBJECT

  public:
    explicit BridgeWatch(QObject* parent = nullptr);
    ~BridgeWatch() override;

    /// By the viewers' link: the driver's is good once. Nothing changes where it watches by that already.
    void start(const QString& link);
    void stop();
    const QList<Visitor>& visitors() const { return visitors_; }

  signals:
    void visitorsChanged();

  private:
    void ask();
    void take(QNetworkReply& reply);
    void become(const QList<Visitor>& visitors);

    std::unique_ptr<QNetworkAccessManager> network_;
    QTimer timer_;
    QUrl status_;
    QByteArray token_;
    QList<Visitor> visitors_;
};

} // namespace gui
