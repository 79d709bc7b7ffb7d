/// The servers that run on this machine, to choose one.
#pragma once

#include "gui/session/server_list.h"

#include <QDialog>
#include <QTimer>

class QPushButton;
class QTreeWidget;

namespace gui {

class ConnectDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ConnectDialog(const QString& present, QWidget* parent = nullptr);

  signals:
    void chosen(const QString& instance);

  private:
    void refresh();
    void choose();

    QString wanted_;
    QTreeWidget* list_;
    QPushButton* connect_;
    QTimer timer_;
};

} // namespace gui
