/// Lines that other programs of the suite print, in the user's language.
#pragma once

#include <QString>

#include <optional>

class QProcess;

namespace gui {

/// Before start(): the process tells its sentences for programs, too (common/process/message.h).
void wantSentences(QProcess& process);

class PrintedLines {
  public:
    /// The line as it is to be shown: in the user's language where a sentence for programs came before it.
    /// Nothing for that sentence itself.
    std::optional<QString> shown(const QString& line);

  private:
    QString translation_; ///< of the next line, behind the name of the program
};

/// All lines of `text`.
QString translatedOutput(const QString& text);

} // namespace gui
