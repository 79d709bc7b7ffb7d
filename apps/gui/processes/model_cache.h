/// Models with their kd-trees, and their indirect light, kept for the next time.
#pragma once

#include <QObject>
#include <QString>

class QProcess;

namespace gui {

/// A folder of .bsp files in the user's cache. The name of a file is a hash of its sources: the model's path,
/// size and time, those of the materials and textures beside it, and how it is imported.
class ModelCache : public QObject {
    Q_OBJECT

  public:
    explicit ModelCache(QObject* parent = nullptr);
    /// A build under way is given up.
    ~ModelCache() override;

    /// Megabytes that the folder may hold; 0: nothing is kept, nor taken.
    void setLimit(int megabytes) { megabytes_ = megabytes; }
    /// The .bsp of a model, or of the model of a .scn; empty when there is none, or when that is a .bsp
    /// itself.
    QString find(const QString& scene) const;
    /// Makes it by a BSPBuilder that stays behind everything else, unless it is there. One at a time: the
    /// build of another model is given up. Failures are silent, for nothing depends on it.
    void keep(const QString& scene);
    /// Where servers keep the indirect light of scenes; empty when nothing is kept.
    QString lightFolder() const;
    bool building() const { return builder_ != nullptr; }

  signals:
    void kept(const QString& bsp);

  private:
    void stop();
    void finish(const QString& bsp);
    void makeRoom() const;

    int megabytes_ = 0;
    QProcess* builder_ = nullptr;
    QString building_; ///< its file
};

} // namespace gui
