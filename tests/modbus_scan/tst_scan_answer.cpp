#include "modbus_pdu.h"
#include "modbus_rtu_framing.h"
#include "scan_answer.h"

#include <QtTest>

using namespace lds::modbus;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

/// With the CRC that belongs to the bytes.
QByteArray frame(const char* text)
{
    const QByteArray bytes = hex(text);
    return encodeRtuFrame(quint8(bytes.at(0)), bytes.sliced(1));
}

} // namespace

class ScanAnswerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asksForTheSpan()
    {
        // 400116 and 400117 are 0x0073 and 0x0074 on the wire; the CRC was worked out by hand elsewhere.
        const QByteArray request = scanRequest(1);
        QCOMPARE(request.first(6), hex("010300730002"));
        QCOMPARE(request.size(), 8);
        QCOMPARE(crc16(request), 0); // over everything, its CRC included
        QCOMPARE(quint8(scanRequest(247).at(0)), 247);
    }

    void tellsWhatCame_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<AnswerKind>("kind");
        QTest::addColumn<int>("unit");
        const QByteArray span = frame("05 03 04 2710 0000"); // 1.0000, low word first
        QTest::newRow("nothing") << QByteArray() << AnswerKind::Silence << 0;
        QTest::newRow("a span") << span << AnswerKind::Sensor << 5;
        QTest::newRow("a span, high word first") << frame("05 03 04 0000 2710") << AnswerKind::Sensor << 5;
        QTest::newRow("no span") << frame("05 03 04 0000 0000") << AnswerKind::OtherDevice << 5;
        QTest::newRow("in its menu") << frame("05 83 04") << AnswerKind::NotReady << 5;
        QTest::newRow("no such address") << frame("05 83 02") << AnswerKind::OtherDevice << 5;
        QTest::newRow("another function") << frame("05 06 0073 0002") << AnswerKind::OtherDevice << 5;
        QTest::newRow("another number of registers")
            << frame("05 03 02 2710") << AnswerKind::OtherDevice << 5;
        QTest::newRow("late") << frame("04 03 04 2710 0000") << AnswerKind::OtherUnit << 4;
        QTest::newRow("late refusal") << frame("04 83 02") << AnswerKind::OtherUnit << 4;
        QTest::newRow("other talk") << frame("04 03 0000 000a") << AnswerKind::Garbage << 0;
        QTest::newRow("the reserved unit") << frame("f8 03 04 2710 0000") << AnswerKind::Garbage << 0;
        QTest::newRow("broadcast cannot answer") << frame("00 03 04 2710 0000") << AnswerKind::Garbage << 0;

        QTest::newRow("echo alone") << scanRequest(5) << AnswerKind::Silence << 0;
        QTest::newRow("echo and answer") << scanRequest(5) + span << AnswerKind::Sensor << 5;
        QTest::newRow("a stray byte in front") << hex("00") + span << AnswerKind::Sensor << 5;
        QTest::newRow("stray bytes behind") << span + hex("00ff") << AnswerKind::Sensor << 5;
        QTest::newRow("one on each side") << hex("ff") + span + hex("00") << AnswerKind::Sensor << 5;
        QTest::newRow("three stray bytes") << span + hex("fe00fc") << AnswerKind::Garbage << 0;

        QByteArray flipped = span;
        flipped[4] = char(flipped[4] ^ 0x10);
        QTest::newRow("one bit flipped") << flipped << AnswerKind::Garbage << 0;
        QTest::newRow("cut short") << span.first(6) << AnswerKind::Garbage << 0;
        QTest::newRow("two frames") << span + frame("05 03 04 4e20 0000") << AnswerKind::Garbage << 0;
        QTest::newRow("the same frame twice") << span + span << AnswerKind::Garbage << 0;
        QTest::newRow("overlapping") << span.first(4) + span.first(3) + span.sliced(4) << AnswerKind::Garbage
                                     << 0;
        QTest::newRow("one byte") << hex("00") << AnswerKind::Garbage << 0;
        QTest::newRow("very much") << QByteArray(100'000, '\x05') << AnswerKind::Garbage << 0;
    }
    void tellsWhatCame()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(AnswerKind, kind);
        QFETCH(int, unit);
        const ScanAnswer answer = judgeScanAnswer(5, bytes);
        QCOMPARE(answer.kind, kind);
        QCOMPARE(int(answer.unit), unit);
    }

    void alsoSaysWhatALateAnswerIs()
    {
        QCOMPARE(judgeScanAnswer(5, frame("04 03 04 2710 0000")).late, AnswerKind::Sensor);
        QCOMPARE(judgeScanAnswer(5, frame("04 83 04")).late, AnswerKind::NotReady);
        QCOMPARE(judgeScanAnswer(5, frame("04 83 01")).late, AnswerKind::OtherDevice);
    }
};

QTEST_GUILESS_MAIN(ScanAnswerTest)
#include "tst_scan_answer.moc"
