/// A folder of this user alone, for files that the window hands to another program.
#pragma once

#include <QString>

#include <memory>

namespace rtcore {
class TemporaryFolder;
} // namespace rtcore

namespace gui {

/// In the session's folder (programs.h); goes with the object, and what a killed window left goes when the
/// next one makes a folder of that kind.
class PrivateFolder {
  public:
    /// `kind` is part of its name: "rtsuite-view-...".
    explicit PrivateFolder(const std::string& kind);
    ~PrivateFolder();

    /// Why there is none; empty when all is well.
    const QString& trouble() const { return trouble_; }
    /// Path of a file of that name in it; empty without a folder.
    QString file(const QString& name) const;

  private:
    std::unique_ptr<rtcore::TemporaryFolder> folder_;
    QString trouble_;
};

} // namespace gui
