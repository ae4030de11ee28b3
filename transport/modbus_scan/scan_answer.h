#pragma once

#include <QByteArray>
#include <QtGlobal>

/// What the bytes say that came after a unit was asked. Pure functions over hostile bytes.
namespace lds::modbus {

enum class AnswerKind : quint8 {
    Silence,
    Sensor,      ///< An HL-G2: its span, in one of the two orders of words.
    NotReady,    ///< Error 04: an HL-G2 in its menu answers so to everything (§6.3.1).
    OtherDevice, ///< Well-formed Modbus that no HL-G2 would say.
    OtherUnit,   ///< Well-formed, and of another unit: an answer that came late.
    Garbage,     ///< Neither: a broken frame, or more than one.
};

struct ScanAnswer {
    AnswerKind kind = AnswerKind::Silence;
    quint8 unit = 0; ///< Who speaks; 0 with Silence and Garbage.
    /// With OtherUnit: what that unit is (Sensor, NotReady or OtherDevice).
    AnswerKind late = AnswerKind::Silence;
};

/// Reads the span (400116, §4.3.6), as a link does to prove that an HL-G2 answers.
QByteArray scanRequest(quint8 unit);
/// `bytes`: everything heard after scanRequest(unit). The request itself in front, as some adapters hear what
/// they send, is passed over; so is a stray byte or two of the line turning around.
ScanAnswer judgeScanAnswer(quint8 unit, const QByteArray& bytes);

} // namespace lds::modbus
