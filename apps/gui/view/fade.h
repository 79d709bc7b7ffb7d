/// One image gives way to another in 0.3 s, so that nothing jumps.
#pragma once

#include <QImage>
#include <QObject>
#include <QVariantAnimation>

namespace gui {

class Fade : public QObject {
    Q_OBJECT

  public:
    explicit Fade(QObject* parent = nullptr);

    /// From that image, from now on.
    void begin(const QImage& from);
    /// At once; nothing is signalled.
    void end();
    bool active() const { return !from_.isNull(); }
    const QImage& from() const { return from_; } ///< null: nothing fades
    double share() const;                        ///< of the new image, 0..1

  signals:
    /// It is time to paint, also when it has ended.
    void stepped();

  private:
    QImage from_;
    QVariantAnimation animation_;
};

} // namespace gui
