/// Name, version, licence, libraries.
#pragma once

#include <QDialog>

namespace gui {

class AboutDialog : public QDialog {
    Q_OBJECT

  public:
    explicit AboutDialog(QWidget* parent = nullptr);
};

} // namespace gui
