/// Opens links that hold a secret in the desktop's browser.
#pragma once

#include <QString>

#include <memory>

namespace gui {

class PrivateFolder;

/// By a page that this user alone can read and that leads on: command lines of browsers can be read by other
/// users of the machine.
class LinkOpener {
  public:
    LinkOpener();
    ~LinkOpener();

    /// False when there is no browser, or no room for the page.
    bool open(const QString& link);
    void forget(); ///< removes the page

  private:
    std::unique_ptr<PrivateFolder> folder_;
};

} // namespace gui
