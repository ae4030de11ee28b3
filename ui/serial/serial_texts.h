#pragma once

#include "bus_scan.h"
#include "communication_change.h"

#include <optional>
#include <QList>
#include <QString>

class QComboBox;

/// Words and choices of RS-485, the sensor's own where it has some.
namespace lds::ui {

QString speedText(int baud);                             ///< "38400 bps"
QString parityText(ports::SerialParity parity);          ///< "EVEN + 1bit"
QString serialText(const ports::SerialSettings& serial); ///< "38400 bps, EVEN + 1bit"

/// The five speeds and the three parities; data() is the number of bits, or the SerialParity.
void fillSpeeds(QComboBox* box);
void fillParities(QComboBox* box);
void showSerial(const ports::SerialSettings& serial, QComboBox* speeds, QComboBox* parities);
ports::SerialSettings serialOf(const QComboBox* speeds, const QComboBox* parities);

/// "1-4, 7" in ascending order, each once; nothing when it is no list of addresses from 1 to 247.
std::optional<QList<quint8>> parseUnits(const QString& text);

/// What was found at one address, and what it means to a person.
QString findingWord(const ports::ScanFinding& finding);
QString findingAdvice(const ports::ScanFinding& finding);

/// Why the guided change cannot begin, or has not come to its end, and what to do.
QString changeSentence(const procedures::CommunicationChange& change);
QString obstacleSentence(procedures::ChangeProblem problem, quint8 unit);
QString changeStepText(procedures::CommunicationChange::State step);

} // namespace lds::ui
