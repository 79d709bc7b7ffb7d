/// Lets Return press a button outside dialogs, too, where Qt takes Space alone.
#pragma once

#include <QObject>

namespace gui {

/// An event filter of the application; works until it is deleted.
class ButtonKeys : public QObject {
    Q_OBJECT

  public:
    explicit ButtonKeys(QObject* parent = nullptr);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace gui
