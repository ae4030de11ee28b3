#pragma once

#include "frame.h"

#include <QString>
#include <QStringList>

/// A message in the texts of a table, a clipboard and a file.
namespace lds::ui {

QString hexText(const QByteArray& bytes);             ///< "00 01 FF"
QString messageTime(const ports::Frame& frame);       ///< "10:21:04.123", local
QString directionWord(ports::Direction direction);    ///< "sent", "received"
QString directionSign(ports::Direction direction);    ///< "→", "←"
QString roundTripText(const ports::Frame& frame);     ///< Milliseconds, "1.8"; empty where there is none.
QString reconstructedNote(const ports::Frame& frame); ///< Why leading bytes are dimmed; empty where none are.

/// Full date and time with zone, direction, round trip ms, message, bytes, how many leading bytes are
/// reconstructed, protocol, sensor: the fields of a saved or copied message and their names.
QStringList messageFields(const ports::Frame& frame);
QStringList messageFieldNames();

QString csvLine(const QStringList& fields); ///< RFC 4180, without the line's end.
QString tabLine(const QStringList& fields); ///< Tabs and line ends inside a field become spaces.

} // namespace lds::ui
