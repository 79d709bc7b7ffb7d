/// The present view, rendered once in higher quality by the Renderer.
#pragma once

#include "gui/session/session.h"

#include <QImage>
#include <QObject>

#include <memory>

class QProcess;
class QTemporaryDir;

namespace gui {

class StillProcess : public QObject {
    Q_OBJECT

  public:
    explicit StillProcess(Session& session, QObject* parent = nullptr);
    ~StillProcess() override; ///< a Renderer that runs is killed

    /// Of the size of a live frame. A still under way is given up.
    void render(int antialiasing, int bloom);
    void cancel();
    bool active() const { return folder_ != nullptr; }

  signals:
    void rendered(const QImage& picture);
    void failed(const QString& text);
    void activeChanged();

  private:
    void exportScene();
    void launch();
    void take(int exitCode, bool crashed);
    void fail(const QString& text);
    QString file(const QString& name) const;

    Session& session_;
    std::unique_ptr<QTemporaryDir> folder_; ///< of the still under way
    QProcess* process_ = nullptr;
    int antialiasing_ = 1, bloom_ = 0;
};

} // namespace gui
