#pragma once

#include "frame.h"

#include <QList>
#include <QString>
#include <tl/expected.hpp>

namespace lds::ui {

enum class MessageFileFormat { Csv, Text };

/// The format a file's name asks for: .csv, anything else is text.
MessageFileFormat formatOf(const QString& path);

/// All messages as a file's content, with a line of names first; UTF-8.
QByteArray messageFile(const QList<ports::Frame>& frames, MessageFileFormat format);

/// Writes the file as a whole or not at all. The error is the system's own text.
tl::expected<void, QString> saveMessages(const QString& path, const QList<ports::Frame>& frames);

} // namespace lds::ui
